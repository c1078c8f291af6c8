using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Columns of reflected or refracted rays of one group of hits.</summary>
internal sealed unsafe class SecondaryColumns<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly R* _originX, _originY, _originZ, _directionX, _directionY, _directionZ;
    private readonly ColorColumns<F> _share;

    public SecondaryColumns(LaneMemory memory, int capacity, bool hasDifferentials)
    {
        _originX = memory.Column<R>(capacity, R.Width);
        _originY = memory.Column<R>(capacity, R.Width);
        _originZ = memory.Column<R>(capacity, R.Width);
        _directionX = memory.Column<R>(capacity, R.Width);
        _directionY = memory.Column<R>(capacity, R.Width);
        _directionZ = memory.Column<R>(capacity, R.Width);
        Differentials = hasDifferentials ? new DifferentialColumns<F>(memory, capacity) : default;
        _share = new ColorColumns<F>(memory, capacity);
    }

    /// <summary>How the rays change from sample to sample; only there if rays carry differentials.</summary>
    public DifferentialColumns<F> Differentials { get; }

    /// <summary>Writes the shares of light that the rays bring.</summary>
    public void SetShare(int packet, F red, F green, F blue)
    {
        _share.R[packet] = red;
        _share.G[packet] = green;
        _share.B[packet] = blue;
    }

    /// <summary>Writes rays: directions of any length become unit vectors; origins lie a slack beside the hit points.</summary>
    /// <param name="packet">Group of lanes.</param>
    /// <param name="s">The hits.</param>
    /// <param name="slack">How far along the geometric normal the origin lies; negative on the other side.</param>
    /// <param name="x">Direction.</param>
    /// <param name="y">Direction.</param>
    /// <param name="z">Direction.</param>
    public void SetRay(int packet, SurfaceBatch<R, F, I> s, R slack, R x, R y, R z)
    {
        R toUnit = R.Of(1) / R.Sqrt(Lane.Dot(x, y, z, x, y, z));
        _directionX[packet] = x * toUnit;
        _directionY[packet] = y * toUnit;
        _directionZ[packet] = z * toUnit;
        _originX[packet] = R.Fma(slack, s.NormalX[packet], s.PointX[packet]);
        _originY[packet] = R.Fma(slack, s.NormalY[packet], s.PointY[packet]);
        _originZ[packet] = R.Fma(slack, s.NormalZ[packet], s.PointZ[packet]);
    }

    /// <summary>Share of light of one ray.</summary>
    public Intensity Share(int i) => _share.Take(i);

    /// <summary>Writes one ray.</summary>
    /// <param name="i">Number of the hit that it starts from.</param>
    /// <param name="weight">Share of its light that reaches the pixel.</param>
    /// <param name="pixel">Number of the pixel in the tile.</param>
    /// <param name="ray">Where it goes.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Write(int i, Intensity weight, int pixel, ref SecondaryRay ray)
    {
        ray.OriginX = R.Take(_originX, i);
        ray.OriginY = R.Take(_originY, i);
        ray.OriginZ = R.Take(_originZ, i);
        ray.DirectionX = R.Take(_directionX, i);
        ray.DirectionY = R.Take(_directionY, i);
        ray.DirectionZ = R.Take(_directionZ, i);
        ray.Red = weight.R;
        ray.Green = weight.G;
        ray.Blue = weight.B;
        ray.Pixel = pixel;
    }
}
