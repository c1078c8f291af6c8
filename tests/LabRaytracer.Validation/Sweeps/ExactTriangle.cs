namespace LabRaytracer.Validation;

/// <summary>A ray against a triangle in exact arithmetic; axes turned so that the direction is longest along the third.</summary>
internal readonly struct ExactTriangle
{
    /// <summary>Number of the axis along which the direction is longest.</summary>
    public readonly int Axis;

    /// <summary>Vertices relative to the ray, sheared so that it runs along the axis.</summary>
    public readonly double[] ShearedX = new double[3], ShearedY = new double[3];

    /// <summary>Edge functions opposite to vertices 0, 1, 2, near enough for signs; all of one sign inside.</summary>
    public readonly double[] Edges = new double[3];

    /// <summary>Sum of the edge functions.</summary>
    public readonly double Sum;

    /// <summary>Weights of the vertices.</summary>
    public readonly Real[] Weights = new Real[3];

    /// <summary>Ray parameter of the plane.</summary>
    public readonly Real T;

    public ExactTriangle(in Ray ray, Point3D[] vertices)
    {
        Real[] d = [ray.Direction.X, ray.Direction.Y, ray.Direction.Z], x = new Real[3], y = new Real[3], z = new Real[3];
        double[] size = [Math.Abs(ray.Direction.X), Math.Abs(ray.Direction.Y), Math.Abs(ray.Direction.Z)];
        Axis = size[0] > size[1] && size[0] > size[2] ? 0 : size[1] > size[2] ? 1 : 2;
        int right = (Axis + 1) % 3, up = (Axis + 2) % 3;
        for (int k = 0; k < 3; k++)
        {
            Point3D v = vertices[k];
            Real[] p = [v.X - (Real)ray.Origin.X, v.Y - (Real)ray.Origin.Y, v.Z - (Real)ray.Origin.Z];

            // Times the direction's longest part, so that no division is needed.
            x[k] = (p[right] * d[Axis]) - (d[right] * p[Axis]);
            y[k] = (p[up] * d[Axis]) - (d[up] * p[Axis]);
            z[k] = p[Axis];
            (ShearedX[k], ShearedY[k]) = ((x[k] / d[Axis]).ToDouble(), (y[k] / d[Axis]).ToDouble());
        }

        Real scale = d[Axis] * d[Axis], sum = 0, depth = 0;
        for (int k = 0; k < 3; k++)
        {
            (int i, int j) = ((k + 1) % 3, (k + 2) % 3);
            Real edge = (x[i] * y[j]) - (y[i] * x[j]);
            Weights[k] = edge;
            Edges[k] = edge.Sign == 0 ? 0 : (edge / scale).ToDouble();
            sum += edge;
            depth += edge * z[k];
        }

        Sum = sum.Sign == 0 ? 0 : (sum / scale).ToDouble();
        T = sum.Sign == 0 ? 0 : depth / (sum * d[Axis]);
        for (int k = 0; k < 3; k++)
        {
            Weights[k] = sum.Sign == 0 ? 0 : Weights[k] / sum;
        }
    }
}
