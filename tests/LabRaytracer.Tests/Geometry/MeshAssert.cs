namespace LabRaytracer.Tests;

/// <summary>What a mesh's tree finds at every lane width is what a test of every triangle finds, bit for bit.</summary>
internal static class MeshAssert
{
    /// <summary>Nearest hits, in doubles and in floats.</summary>
    /// <returns>The hits in doubles, of which there is at least one.</returns>
    public static MeshHit[] Nearest(TriangleMesh mesh, Ray[] rays)
    {
        MeshHit[] expected = MeshHits<Double1, Float1, Int1>.ByLoop(mesh, rays);
        Assert.Contains(expected, hit => hit.T > 0);
        Assert.Equal(expected, MeshHits<Double16, Float16, Int16>.ByTree(mesh, rays));
        Assert.Equal(expected, MeshHits<Double8, Float8, Int8>.ByTree(mesh, rays));
        Assert.Equal(expected, MeshHits<Double4, Float4, Int4>.ByTree(mesh, rays));

        MeshHit[] inFloats = MeshHits<Float1, Float1, Int1>.ByLoop(mesh, rays);
        Assert.Equal(inFloats, MeshHits<Float16, Float16, Int16>.ByTree(mesh, rays));
        Assert.Equal(inFloats, MeshHits<Float8, Float8, Int8>.ByTree(mesh, rays));
        Assert.Equal(inFloats, MeshHits<Float4, Float4, Int4>.ByTree(mesh, rays));
        return expected;
    }

    /// <summary>Which rays are blocked before a limit of their own, in doubles and in floats; a ray may leave a triangle.</summary>
    /// <returns>Those in doubles.</returns>
    public static bool[] Blocked(TriangleMesh mesh, Ray[] rays, double[] limits, int[]? sources)
    {
        bool[] expected = BlockedByLoop<Double1, Float1, Int1>(mesh, rays, limits, sources);
        Assert.Equal(expected, MeshHits<Double16, Float16, Int16>.Blocked(mesh, rays, limits, sources));
        Assert.Equal(expected, MeshHits<Double8, Float8, Int8>.Blocked(mesh, rays, limits, sources));
        Assert.Equal(expected, MeshHits<Double4, Float4, Int4>.Blocked(mesh, rays, limits, sources));

        bool[] inFloats = BlockedByLoop<Float1, Float1, Int1>(mesh, rays, [.. limits.Select(limit => (double)(float)limit)], sources);
        Assert.Equal(inFloats, MeshHits<Float16, Float16, Int16>.Blocked(mesh, rays, limits, sources));
        Assert.Equal(inFloats, MeshHits<Float8, Float8, Int8>.Blocked(mesh, rays, limits, sources));
        Assert.Equal(inFloats, MeshHits<Float4, Float4, Int4>.Blocked(mesh, rays, limits, sources));
        return expected;
    }

    /// <summary>Which rays any triangle blocks but the one that they leave.</summary>
    public static bool[] BlockedByLoop<R, F, I>(TriangleMesh mesh, Ray[] rays, double[] limits, int[]? sources)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> =>
        [.. MeshHits<R, F, I>.ByLoop(mesh, rays, sources: sources).Select((hit, i) => hit.T > 0 && hit.T < limits[i])];
}
