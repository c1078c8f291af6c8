namespace LabRaytracer;

/// <summary>The call for one ray of a wide camera: the same formulas with one lane.</summary>
internal static unsafe class ScalarCamera
{
    /// <summary><see cref="Camera.RayAt(double, double, int, int)"/> by the wide path.</summary>
    public static Ray RayAt(IWideCamera camera, double x, double y, int width, int height)
    {
        Double1* n = stackalloc Double1[8];
        n[0] = new Double1(x);
        n[1] = new Double1(y);
        RayColumns<Double1> rays = new()
        {
            OriginX = n + 2, OriginY = n + 3, OriginZ = n + 4, DirectionX = n + 5, DirectionY = n + 6, DirectionZ = n + 7,
        };
        camera.Rays(n, n + 1, rays, 1, width, height);
        return new Ray(new Point3D(n[2].Value, n[3].Value, n[4].Value), new Vector3D(n[5].Value, n[6].Value, n[7].Value));
    }

    /// <summary><see cref="Camera.RayAt(double, double, SquarePoint, int, int)"/> by the wide path.</summary>
    public static Ray Spread(IWideLensCamera camera, in Ray middle, SquarePoint lens)
    {
        Double1* n = stackalloc Double1[8];
        double[] numbers = [lens.S, lens.T, middle.Origin.X, middle.Origin.Y, middle.Origin.Z, middle.Direction.X, middle.Direction.Y, middle.Direction.Z];
        for (int i = 0; i < 8; i++)
        {
            n[i] = new Double1(numbers[i]);
        }

        RayColumns<Double1> rays = new()
        {
            OriginX = n + 2, OriginY = n + 3, OriginZ = n + 4, DirectionX = n + 5, DirectionY = n + 6, DirectionZ = n + 7,
        };
        camera.Spread(n, n + 1, rays, 1);
        return new Ray(new Point3D(n[2].Value, n[3].Value, n[4].Value), new Vector3D(n[5].Value, n[6].Value, n[7].Value));
    }

    /// <summary><see cref="Camera.DifferentialAt"/> by the wide path.</summary>
    public static RayDifferential DifferentialAt(IWideCamera camera, double x, double y, int width, int height)
    {
        using LaneMemory memory = new();
        VectorColumns<Double1> direction = new(memory, 1);
        DifferentialColumns<Double1> differential = new(memory, 1);
        direction.Put(0, RayAt(camera, x, y, width, height).Direction);
        camera.Differentials(direction, differential, 1, width, height, 1);
        return differential.Take(0);
    }
}
