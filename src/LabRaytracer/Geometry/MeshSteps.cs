namespace LabRaytracer;

/// <summary>What changes over steps on a mesh.</summary>
internal static unsafe class MeshSteps
{
    /// <summary>Shading normals, of any length, and their changes over a step in object space; zero for a mesh without normals of its own.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="triangle">Triangle numbers.</param>
    /// <param name="a">Weights of vertex 1.</param>
    /// <param name="b">Weights of vertex 2.</param>
    /// <param name="step">Steps in object space.</param>
    /// <param name="normal">The normals and their changes.</param>
    public static void BendNormal<R, F, I>(MeshData mesh, I triangle, R a, R b, (R X, R Y, R Z) step, out NormalLanes<R> normal)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        normal = default;
        if (!mesh.Normals.IsPresent)
        {
            return;
        }

        I corner = triangle * I.Of(3);
        TriangleGradient<R> weights = Gradient<R, F, I>(mesh, corner);
        R stepA = Lane.Dot(weights.SecondX, weights.SecondY, weights.SecondZ, step.X, step.Y, step.Z);
        R stepB = Lane.Dot(weights.ThirdX, weights.ThirdY, weights.ThirdZ, step.X, step.Y, step.Z);
        MeshCorners<I> at = new(mesh.NormalCorners, corner, 3);
        (normal.X, normal.StepX) = Mix<R, F, I>(mesh.Normals, at, 0, a, b, stepA, stepB);
        (normal.Y, normal.StepY) = Mix<R, F, I>(mesh.Normals, at, 1, a, b, stepA, stepB);
        (normal.Z, normal.StepZ) = Mix<R, F, I>(mesh.Normals, at, 2, a, b, stepA, stepB);
    }

    /// <summary>Gradients of the mesh's own texture coordinates with respect to the local point.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="triangle">Triangle numbers.</param>
    /// <param name="gradient">Gradients of u and v.</param>
    public static void SurfaceGradient<R, F, I>(MeshData mesh, I triangle, out GradientLanes<R> gradient)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        gradient = default;
        if (!mesh.TextureCoordinates.IsPresent)
        {
            return;
        }

        I corner = triangle * I.Of(3);
        TriangleGradient<R> weights = Gradient<R, F, I>(mesh, corner);
        MeshCorners<I> at = new(mesh.TextureCorners, corner, 2);
        (_, R u1, R u2) = Edges<R, F, I>(mesh.TextureCoordinates, at, 0);
        (_, R v1, R v2) = Edges<R, F, I>(mesh.TextureCoordinates, at, 1);
        (gradient.UX, gradient.UY, gradient.UZ) = weights.Of(u1, u2);
        (gradient.VX, gradient.VY, gradient.VZ) = weights.Of(v1, v2);
    }

    private static TriangleGradient<R> Gradient<R, F, I>(MeshData mesh, I corner)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        MeshCorners<I> at = new(mesh.Corners, corner, 3);
        (_, R x1, R x2) = Edges<R, F, I>(mesh.Positions, at, 0);
        (_, R y1, R y2) = Edges<R, F, I>(mesh.Positions, at, 1);
        (_, R z1, R z2) = Edges<R, F, I>(mesh.Positions, at, 2);
        return new TriangleGradient<R>(x1, y1, z1, x2, y2, z2);
    }

    private static (R Value, R Step) Mix<R, F, I>(MeshColumn column, in MeshCorners<I> corners, int k, R a, R b, R stepA, R stepB)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        (R at0, R to1, R to2) = Edges<R, F, I>(column, corners, k);
        return (R.Fma(a, to1, R.Fma(b, to2, at0)), R.Fma(stepA, to1, stepB * to2));
    }

    /// <summary>A number at vertex 0, and its changes towards vertices 1 and 2.</summary>
    private static (R At0, R To1, R To2) Edges<R, F, I>(MeshColumn column, in MeshCorners<I> corners, int k)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I offset = I.Of(k);
        R at0 = column.Gather<R, F, I>(corners.First + offset);
        return (at0, column.Gather<R, F, I>(corners.Second + offset) - at0, column.Gather<R, F, I>(corners.Third + offset) - at0);
    }
}
