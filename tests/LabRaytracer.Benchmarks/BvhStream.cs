namespace LabRaytracer.Benchmarks;

/// <summary>Camera rays of the bench scene s4 at a lane width, each group of lanes a compact block of pixels.</summary>
internal sealed unsafe class BvhStream<R, F, I> : IDisposable
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const int Width = 1920, Height = 1080, Block = 4, Step = 4;
    private readonly LaneMemory _memory = new();
    private readonly RayBatch<R, F, I> _rays;
    private readonly HitBatch<R, F, I> _hits;
    private readonly ShapeGroup<R, F, I> _mesh;

    public BvhStream(TriangleMesh mesh)
    {
        _mesh = mesh.CreateGroup<R, F, I>(Transform.Identity);
        _mesh.Add(mesh, Transform.Identity, 0);
        _mesh.Freeze(_memory, 2);
        _rays = new RayBatch<R, F, I>(_memory, Count) { Count = Count };
        _hits = new HitBatch<R, F, I>(_memory, Count);
        int ray = 0;
        for (int y = 0; y < Height; y += Block * Step)
        {
            for (int x = 0; x < Width; x += Block * Step)
            {
                for (int i = 0; i < Block * Block; i++)
                {
                    Aim(ray++, x + (i % Block) + 0.5, y + (i / Block) + 0.5);
                }
            }
        }
    }

    /// <summary>Rays in the stream: every fourth block of 4 x 4 pixels in each direction.</summary>
    public static int Count => Width / (Block * Step) * ((Height + (Block * Step) - 1) / (Block * Step)) * Block * Block;

    public void Nearest()
    {
        _hits.Clear(_rays);
        _mesh.Nearest(0, _rays, _hits, 0, _rays.Packets);
    }

    public void Dispose() => _memory.Dispose();

    private void Aim(int ray, double px, double py)
    {
        Point3D eye = new(0, 1.8, 3.2);
        Vector3D forward = (new Point3D(0, -0.1, 0) - eye).Normalized();
        Vector3D right = Vector3D.Cross(forward, Vector3D.UnitY).Normalized();
        Vector3D up = Vector3D.Cross(right, forward);
        double half = Math.Tan(20 * Math.PI / 180);
        Vector3D aim = (forward + (right * (((2 * px / Width) - 1) * half * Width / Height)) + (up * ((1 - (2 * py / Height)) * half))).Normalized();
        R.Put(_rays.OriginX, ray, eye.X);
        R.Put(_rays.OriginY, ray, eye.Y);
        R.Put(_rays.OriginZ, ray, eye.Z);
        R.Put(_rays.DirectionX, ray, aim.X);
        R.Put(_rays.DirectionY, ray, aim.Y);
        R.Put(_rays.DirectionZ, ray, aim.Z);
        R.Put(_rays.Limit, ray, double.PositiveInfinity);
    }
}
