using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>An affine map of texture coordinates: scale, then rotation about a centre, then offset.</summary>
/// <remarks>
/// <para>uv' = offset + centre + R(rotation) S(scale) (uv - centre): the order T R S of the glTF extension KHR_texture_transform.</para>
/// <para>Positive angles turn (u, v) counter-clockwise, seen with u to the right and v up. Files whose v goes down negate the angle.
/// The picture itself seems to move the opposite way: scale 2 shows it twice.</para>
/// <para>Immutable, thread safe. Two transforms with the same effect on numbers are equal.</para>
/// </remarks>
public sealed record UvTransform
{
    private readonly double _uu, _uv, _u0;
    private readonly double _vu, _vv, _v0;

    /// <summary>A transform from its parts.</summary>
    /// <param name="offset">Added last, texture units; finite.</param>
    /// <param name="rotationDegrees">Angle, degrees, counter-clockwise with v up; finite. Multiples of 90 are exact.</param>
    /// <param name="scale">Factors of u and v, applied first; finite. 0 flattens, negative mirrors.</param>
    /// <param name="center">The point that scale and rotation leave in place, texture units; finite.</param>
    /// <exception cref="ArgumentException">A number is NaN or infinite, or so large that the product is.</exception>
    public UvTransform(TextureCoordinate offset, double rotationDegrees, TextureCoordinate scale, TextureCoordinate center)
    {
        double[] numbers = [offset.U, offset.V, rotationDegrees, scale.U, scale.V, center.U, center.V];
        if (!numbers.All(double.IsFinite))
        {
            throw new ArgumentException($"A texture transform needs finite numbers; got offset {offset}, rotation {rotationDegrees}, scale {scale}, center {center}.");
        }

        (double sin, double cos) = Elementary.SinCosDegrees(rotationDegrees);
        (_uu, _uv) = (cos * scale.U, -sin * scale.V);
        (_vu, _vv) = (sin * scale.U, cos * scale.V);
        _u0 = offset.U + center.U - Math.FusedMultiplyAdd(_uu, center.U, _uv * center.V);
        _v0 = offset.V + center.V - Math.FusedMultiplyAdd(_vu, center.U, _vv * center.V);
        if (!double.IsFinite(_u0) || !double.IsFinite(_v0))
        {
            throw new ArgumentException($"The texture transform overflows: offset {offset}, scale {scale} and center {center} are too large.");
        }
    }

    private UvTransform(double uu, double uv, double vu, double vv, TextureCoordinate from, TextureCoordinate to)
    {
        (_uu, _uv, _vu, _vv) = (uu, uv, vu, vv);
        _u0 = to.U - Math.FusedMultiplyAdd(uu, from.U, uv * from.V);
        _v0 = to.V - Math.FusedMultiplyAdd(vu, from.U, vv * from.V);
    }

    /// <summary>The transform that changes nothing.</summary>
    public static UvTransform Identity { get; } = new(new TextureCoordinate(0, 0), 0, new TextureCoordinate(1, 1), new TextureCoordinate(0, 0));

    /// <summary>Tells whether the transform changes nothing.</summary>
    public bool IsIdentity => this == Identity;

    /// <summary>The transform that shows a picture once on a rectangle of texture space: the rectangle's corners become (0, 0) to (1, 1).</summary>
    /// <param name="center">Centre of the rectangle; finite.</param>
    /// <param name="size">Width and height of the rectangle before it is turned; finite, above 0.</param>
    /// <param name="rotationDegrees">Turn of the rectangle, degrees, counter-clockwise with v up; finite. Multiples of 90 are exact.</param>
    /// <exception cref="ArgumentException">A number is not finite, a size is not above 0, or so small that its inverse is no number.</exception>
    public static UvTransform Placing(TextureCoordinate center, TextureCoordinate size, double rotationDegrees)
    {
        double perU = 1 / size.U, perV = 1 / size.V;
        if (!(size.U > 0 && size.V > 0) || !new[] { center.U, center.V, size.U, size.V, perU, perV, rotationDegrees }.All(double.IsFinite))
        {
            throw new ArgumentException($"A place needs finite numbers and sizes above 0; got center {center}, size {size}, rotation {rotationDegrees}.");
        }

        (double sin, double cos) = Elementary.SinCosDegrees(rotationDegrees);
        return new UvTransform(cos * perU, sin * perU, -sin * perV, cos * perV, center, new TextureCoordinate(0.5, 0.5));
    }

    /// <summary>The coordinates that become (1/2, 1/2): the centre of a picture that is placed; null if there are none or many.</summary>
    internal TextureCoordinate? Center
    {
        get
        {
            double area = (_uu * _vv) - (_uv * _vu), u = 0.5 - _u0, v = 0.5 - _v0;
            TextureCoordinate center = new(((_vv * u) - (_uv * v)) / area, ((_uu * v) - (_vu * u)) / area);
            return double.IsFinite(center.U) && double.IsFinite(center.V) ? center : null;
        }
    }

    /// <summary>The transformed coordinates.</summary>
    /// <remarks>For quarter turns the error is at most 4 units of 2^-53 of the sum of the terms' magnitudes.</remarks>
    /// <param name="coordinate">Texture coordinates; finite.</param>
    public TextureCoordinate Apply(TextureCoordinate coordinate)
    {
        (Double1 u, Double1 v) = Apply(new Double1(coordinate.U), new Double1(coordinate.V));
        return new TextureCoordinate(u.Value, v.Value);
    }

    /// <summary>The transformed footprint: its steps are scaled and turned, not moved.</summary>
    /// <param name="footprint">Steps in texture space.</param>
    public TextureFootprint Apply(in TextureFootprint footprint)
    {
        (Double1 ux, Double1 vx) = ApplyToStep(new Double1(footprint.DuDx), new Double1(footprint.DvDx));
        (Double1 uy, Double1 vy) = ApplyToStep(new Double1(footprint.DuDy), new Double1(footprint.DvDy));
        return new TextureFootprint(ux.Value, vx.Value, uy.Value, vy.Value);
    }

    /// <summary>A transformed step, any number at a time.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal (T U, T V) ApplyToStep<T>(T u, T v)
        where T : unmanaged, IReal<T> => (
            T.Fma(T.Of(_uu), u, T.Of(_uv) * v),
            T.Fma(T.Of(_vu), u, T.Of(_vv) * v));

    /// <summary>The transformed coordinates, any number at a time.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal (T U, T V) Apply<T>(T u, T v)
        where T : unmanaged, IReal<T> => (
            T.Fma(T.Of(_uu), u, T.Fma(T.Of(_uv), v, T.Of(_u0))),
            T.Fma(T.Of(_vu), u, T.Fma(T.Of(_vv), v, T.Of(_v0))));
}
