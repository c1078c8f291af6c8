namespace LabRaytracer;

/// <content>Powers of two that bring huge and tiny points into the range where squares neither overflow nor underflow.</content>
internal static partial class Elementary
{
    /// <summary>Magnitude of a coordinate: 0 for NaN, the largest finite number for infinity.</summary>
    private static T AnyMagnitude<T>(T a)
        where T : unmanaged, IReal<T> =>
        T.Min(T.Select(T.Equal(a, a), T.Abs(a), T.Zero), T.Of(T.IsSingle ? float.MaxValue : double.MaxValue));

    /// <summary>Factor for both coordinates of the azimuth: their sum and the remainder of their quotient stay normal.</summary>
    private static T AzimuthScale<T>(T larger)
        where T : unmanaged, IReal<T>
    {
        T scale = T.Select(T.Less(larger, Power<T>(20, -200)), Power<T>(60, 400), T.Of(1));
        return T.Select(T.Less(Power<T>(60, 900), larger), Power<T>(-60, -300), scale);
    }

    /// <summary>Factors for the polar angle of a point whose squares may leave the range.</summary>
    /// <param name="larger">The larger of |x| and |z|.</param>
    /// <param name="height">|y|.</param>
    /// <param name="squares">Factor for x and z before they are squared.</param>
    /// <param name="radiusScale">Factor for the radius made of them.</param>
    /// <param name="heightScale">Factor for |y|.</param>
    /// <param name="undo">Factor for the angle from the pole; 1 unless the angle is so small that it is proportional to the quotient.</param>
    private static void RadiusScales<T>(T larger, T height, out T squares, out T radiusScale, out T heightScale, out T undo)
        where T : unmanaged, IReal<T>
    {
        T one = T.Of(1);
        T tiny = T.Less(larger, Power<T>(-40, -300));
        T huge = T.Less(Power<T>(60, 400), larger);
        T far = ~huge & T.Less(larger * Power<T>(60, 400), height);
        T tall = ~tiny & ~huge & ~far & T.Less(Power<T>(60, 900), height);
        squares = T.Select(tiny, Power<T>(100, 600), T.Select(huge, Power<T>(-100, -600), one));
        radiusScale = T.Select(far, T.Select(tiny, Power<T>(-70, -400), Power<T>(30, 200)), T.Select(tall, Power<T>(-60, -300), one));
        heightScale = T.Select(far, Power<T>(-10, -100), T.Select(tall, Power<T>(-60, -300), squares));
        undo = T.Select(far, Power<T>(-40, -300), one);
    }
}
