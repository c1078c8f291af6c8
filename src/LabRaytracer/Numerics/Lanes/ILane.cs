namespace LabRaytracer;

/// <summary>
/// What the renderer needs of a lane type beyond arithmetic: conversion between precisions of the same width, and gathers.
/// </summary>
/// <typeparam name="R">The implementing lane type: geometry's precision (double by default).</typeparam>
/// <typeparam name="F">Float lanes of the same width: boxes, texel weights, colours.</typeparam>
/// <typeparam name="I">Integer lanes of the same width: indices.</typeparam>
internal interface ILane<R, F, I> : IReal<R>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Each lane rounded to float.</summary>
    static abstract F ToSingle(R a);

    /// <summary>Each lane widened (or kept), exactly.</summary>
    static abstract R FromSingle(F a);

    /// <summary>Each lane truncated towards zero; the value must lie inside the range of int.</summary>
    static abstract I ToInt32(R a);

    /// <summary>Each integer converted to a real number (rounded in float lanes above 2^24).</summary>
    static abstract R FromInt32(I a);

    /// <summary>A geometry mask as a float mask of the same truth values.</summary>
    static abstract F MaskToSingle(R mask);

    /// <summary>A float mask as a geometry mask of the same truth values.</summary>
    static abstract R MaskFromSingle(F mask);

    /// <summary>A geometry mask as an integer mask of the same truth values.</summary>
    static abstract I MaskToInt32(R mask);

    /// <summary>An integer mask as a geometry mask of the same truth values.</summary>
    static abstract R MaskFromInt32(I mask);

    /// <summary>Elements <c>column[index[lane]]</c> of a column of scalars.</summary>
    /// <param name="column">First element of the column (of whole lanes in memory, seen as scalars).</param>
    /// <param name="index">Element numbers; each must lie inside the column.</param>
    static abstract unsafe R Gather(R* column, I index);

    /// <summary>One element of a column of scalars, in every lane.</summary>
    static abstract unsafe R Broadcast(R* column, int element);

    /// <summary>Writes one element of a column of scalars.</summary>
    static abstract unsafe void Put(R* column, int element, double value);

    /// <summary>Reads one element of a column of scalars.</summary>
    static abstract unsafe double Take(R* column, int element);
}
