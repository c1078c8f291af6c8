namespace LabRaytracer;

/// <summary>Four lanes that are read from consecutive numbers and turned: rows of points become columns of coordinates.</summary>
/// <typeparam name="T">The implementing lane type.</typeparam>
internal interface IQuad<T> : IReal<T>
    where T : unmanaged, IQuad<T>
{
    /// <summary>Four consecutive doubles, rounded to the lanes' precision.</summary>
    static abstract unsafe T Load(double* numbers);

    /// <summary>Four consecutive doubles, rounded to float.</summary>
    static abstract unsafe T LoadRounded(double* numbers);

    /// <summary>Four consecutive floats.</summary>
    static abstract unsafe T Load(float* numbers);

    /// <summary>The first, second and third lanes of four rows, each in the order of the rows.</summary>
    static abstract void Turn(T row0, T row1, T row2, T row3, out T first, out T second, out T third);
}
