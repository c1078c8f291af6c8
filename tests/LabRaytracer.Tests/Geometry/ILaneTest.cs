namespace LabRaytracer.Tests.Geometry;

/// <summary>A check that runs at any width and precision.</summary>
internal interface ILaneTest
{
    void Run<R, F, I>()
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>;
}

/// <summary>Runs a check at one of the widths or at all of them.</summary>
internal static class LaneTests
{
    public static void RunAllDoubles(this ILaneTest test)
    {
        test.Run<Double1, Float1, Int1>();
        test.Run<Double4, Float4, Int4>();
        test.Run<Double8, Float8, Int8>();
        test.Run<Double16, Float16, Int16>();
    }

    public static void RunAllFloats(this ILaneTest test)
    {
        test.Run<Float1, Float1, Int1>();
        test.Run<Float4, Float4, Int4>();
        test.Run<Float8, Float8, Int8>();
        test.Run<Float16, Float16, Int16>();
    }
}
