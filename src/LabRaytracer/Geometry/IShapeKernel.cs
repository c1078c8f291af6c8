namespace LabRaytracer;

/// <summary>The formulas of one class of shapes, written once for any width and precision.</summary>
/// <remarks>
/// The scalar calls of the public shape run the same formulas with one lane. Both methods ask not to be inlined: the compiler's budget for inlining the
/// lane operators grows with the method that it starts from, and a whole kernel inside a short loop exceeds it.
/// </remarks>
internal interface IShapeKernel
{
    /// <summary>How many numbers describe one shape.</summary>
    static abstract int ParameterCount { get; }

    /// <summary>Writes the numbers that describe a shape.</summary>
    /// <param name="shape">A shape of the kernel's class.</param>
    /// <param name="transform">Object space to world space; only the kernel of transformed shapes looks at it.</param>
    /// <param name="numbers">Where they go: <see cref="ParameterCount"/> numbers.</param>
    static abstract void Describe(Shape shape, Transform transform, Span<double> numbers);

    /// <summary>Nearest hits with t above 0.</summary>
    /// <param name="shape">The shape's numbers.</param>
    /// <param name="ray">Rays in object space.</param>
    /// <param name="t">Ray parameters where the mask is true; anything elsewhere.</param>
    /// <returns>Mask of hits with 0 &lt; t.</returns>
    static abstract R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>;

    /// <summary>
    /// Tells whether the surface is convex: a ray that leaves it on its outer side never meets it again, so it need not be looked at. Default: no.
    /// </summary>
    static virtual bool IsConvex => false;

    /// <summary>Tells whether the kernel has a quick look of its own; others are looked at by the sphere around their box. Default: no.</summary>
    static virtual bool HasQuickLook => false;

    /// <summary>Tells whether a shape is so quick to intersect that <see cref="IntersectQuick"/> takes the place of a quick look. Default: no.</summary>
    /// <param name="numbers">The shape's numbers.</param>
    static virtual bool IsQuick(ReadOnlySpan<double> numbers) => false;

    /// <summary><see cref="Intersect"/> of shapes that <see cref="IsQuick"/>, small enough to be compiled into a loop.</summary>
    /// <param name="shape">The shape's numbers.</param>
    /// <param name="ray">Rays, in memory.</param>
    /// <param name="packet">Group of lanes.</param>
    /// <param name="t">Ray parameters where the mask is true; anything elsewhere.</param>
    static virtual R IntersectQuick<R, P>(in P shape, in RayColumns<R> ray, int packet, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => throw new NotSupportedException();

    /// <summary>
    /// A quick look in floats: false only where <see cref="Intersect"/> is certain to find no hit, whatever its precision.
    /// It decides what need not be computed, never what is hit.
    /// </summary>
    /// <param name="shape">The shape's numbers, rounded to float.</param>
    /// <param name="ray">Rays in the space of the shape, rounded to float.</param>
    /// <returns>Mask of rays that may hit. By default all of them.</returns>
    static virtual F MayHit<F, P>(in P shape, in RayLanes<F> ray)
        where F : unmanaged, IReal<F>
        where P : struct, IParameters<F> => F.True;

    /// <summary>
    /// A quick look at many rays at once: false only where <see cref="Intersect"/> is certain to find no hit before the limit of any of them, whatever its precision.
    /// Default: it may find some. Only asked where there is a quick look.
    /// </summary>
    /// <param name="numbers">The shape's numbers.</param>
    /// <param name="bounds">Bounds of the rays, in the space of the shape.</param>
    static virtual bool MayMeet(ReadOnlySpan<double> numbers, in RayBounds bounds) => true;

    /// <summary>
    /// The ray parameters of hits as accurate as is promised. <see cref="Intersect"/>, which looks at every candidate, may leave the hard ones rough:
    /// it decides hit or miss; the nearest hit alone pays for its last digits.
    /// </summary>
    /// <param name="shape">The shape's numbers.</param>
    /// <param name="ray">Rays in object space.</param>
    /// <param name="t">Ray parameters as <see cref="Intersect"/> gave them.</param>
    static virtual R Refine<R, P>(in P shape, in RayLanes<R> ray, R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => t;

    /// <summary>Surface points of hits; every field of <paramref name="s"/> is written (unused ones as zero).</summary>
    /// <param name="shape">The shape's numbers.</param>
    /// <param name="ray">Rays in object space.</param>
    /// <param name="t">Ray parameters as <see cref="Intersect"/> gave them; becomes what <see cref="Refine"/> makes of them.</param>
    /// <param name="s">The surface, in the ray's space.</param>
    static abstract void Surface<R, P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>;

    /// <summary>Tells whether the normals for shading are the geometric ones and <see cref="Smooth"/> writes them. Default: no.</summary>
    static virtual bool IsSmooth => false;

    /// <summary>The numbers of <see cref="Surface"/> straight into columns: nothing is written that nobody reads.</summary>
    /// <param name="shape">The shape's numbers.</param>
    /// <param name="ray">Rays in object space.</param>
    /// <param name="t">Ray parameters as <see cref="Intersect"/> gave them.</param>
    /// <param name="to">Where the surface goes.</param>
    /// <param name="packet">Group of lanes in the columns.</param>
    /// <param name="needs">Columns that somebody reads.</param>
    /// <returns>Bits of the lanes whose numbers are rough yet: they are left to <see cref="SmoothRough"/>.</returns>
    static virtual uint Smooth<R, P>(in P shape, in RayLanes<R> ray, in R t, in SurfaceColumns<R> to, int packet, SurfaceNeeds needs)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => throw new NotSupportedException();

    /// <summary><see cref="Smooth"/> for hits that it found rough, with as many digits as they need.</summary>
    /// <param name="shape">The shape's numbers.</param>
    /// <param name="ray">Rays in object space.</param>
    /// <param name="t">As for <see cref="Surface"/>.</param>
    /// <param name="to">Where the surface goes.</param>
    /// <param name="packet">Group of lanes in the columns.</param>
    /// <param name="needs">Columns that somebody reads.</param>
    static virtual void SmoothRough<R, P>(in P shape, in RayLanes<R> ray, ref R t, in SurfaceColumns<R> to, int packet, SurfaceNeeds needs)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => throw new NotSupportedException();

    /// <summary><see cref="Smooth"/> of shapes that <see cref="IsQuick"/>, small enough to be compiled into a loop; their t is accurate already.</summary>
    /// <param name="shape">The shape's numbers.</param>
    /// <param name="originX">Rays in object space.</param>
    /// <param name="originY">Rays in object space.</param>
    /// <param name="originZ">Rays in object space.</param>
    /// <param name="directionX">Rays in object space.</param>
    /// <param name="directionY">Rays in object space.</param>
    /// <param name="directionZ">Rays in object space.</param>
    /// <param name="t">Ray parameters of the hits.</param>
    /// <param name="to">Where the surface goes.</param>
    /// <param name="packet">Group of lanes in the columns.</param>
    /// <param name="needs">Columns that somebody reads.</param>
    static virtual void SmoothQuick<R, P>(
        in P shape, R originX, R originY, R originZ, R directionX, R directionY, R directionZ, R t, in SurfaceColumns<R> to, int packet, SurfaceNeeds needs)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => throw new NotSupportedException();

    /// <summary>Makes t correctly rounded and the point as accurate as twice the digits allow, where the shape can; the rest stays. Double lanes only.</summary>
    /// <param name="shape">The shape's numbers.</param>
    /// <param name="ray">Rays in object space.</param>
    /// <param name="t">Ray parameters as <see cref="Surface"/> left them.</param>
    /// <param name="s">The surface as <see cref="Surface"/> wrote it.</param>
    static virtual void Sharpen<R, P>(in P shape, in RayLanes<R> ray, ref R t, ref SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
    }

    /// <summary>The linear map from the space of the ray to the shape's unit form, for steps in the tangent plane.</summary>
    /// <param name="shape">The shape's numbers.</param>
    /// <param name="frame">The map.</param>
    static abstract void LocalFrame<R, P>(in P shape, out LinearLanes<R> frame)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>;

    /// <summary>Tells whether the shading normal changes over the surface. Default: no.</summary>
    static virtual bool IsCurved => false;

    /// <summary>Shading normals of the unit form, of any length, and their changes over steps; only called if the shape is curved.</summary>
    /// <param name="shape">The shape's numbers.</param>
    /// <param name="x">Local point.</param>
    /// <param name="y">Local point.</param>
    /// <param name="z">Local point.</param>
    /// <param name="stepX">Step in the unit form.</param>
    /// <param name="stepY">Step in the unit form.</param>
    /// <param name="stepZ">Step in the unit form.</param>
    /// <param name="normal">The normals and their changes.</param>
    static virtual void BendNormal<R, P>(in P shape, R x, R y, R z, R stepX, R stepY, R stepZ, out NormalLanes<R> normal)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => normal = default;

    /// <summary>Gradient of the shape's own texture coordinates with respect to the local point. Default: zero, of shapes that have none.</summary>
    /// <param name="shape">The shape's numbers.</param>
    /// <param name="gradient">Gradients of u and v.</param>
    static virtual void SurfaceGradient<R, P>(in P shape, out GradientLanes<R> gradient)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => gradient = default;
}
