namespace LabRaytracer.Tests.Texturing;

/// <summary>Textures looked up the way the renderer does it.</summary>
internal static unsafe class SamplerRun
{
    /// <summary>Nasty and ordinary coordinates: ends, just beside them, seams between texels, far away.</summary>
    public static double[] Coordinates { get; } =
    [
        0, -0.0, 1, 0.5, 0.25, 1 / 3.0, 0.999999, Math.BitDecrement(1), Math.BitIncrement(1), Math.BitDecrement(0.5), double.Epsilon, -double.Epsilon, -1e-17,
        -0.25, -1, -1.75, 2, 3.5, 17.3, 1e5 + 0.1, -1e5 - 0.1, 1e15, -1e15, 1e300, -1e300, 0.125, 0.0625, 0.8, 0.6, 0.1, 0.3, 0.7, 0.9,
    ];

    /// <summary>Lookups at all pairs of the coordinates, with a local point and normal made of them.</summary>
    public static TextureLookup[] Lookups(TextureWrap wrapU, TextureWrap wrapV) =>
        [.. from u in Coordinates from v in Coordinates select new TextureLookup(new TextureCoordinate(u, v), new Point3D(u, v, u - v), new Vector3D(0.6, v > 0 ? 0.8 : -0.8, 0), wrapU, wrapV)
        {
            WorldPoint = new Point3D(v, u, 1), WorldNormal = new Vector3D(0, 0.6, 0.8), Footprint = Steps(u, v), LocalFootprint = new SurfaceFootprint(new Vector3D(Steps(u, v).DuDx, 0.1, 0), new Vector3D(0, Steps(u, v).DvDx, 0.01)),
            WorldFootprint = new SurfaceFootprint(new Vector3D(0, Steps(v, u).DuDx, 0), new Vector3D(0.125, 0, Steps(v, u).DvDx)),
        }];

    /// <summary>Footprints from none over fractions of a cell to several, exact as floats.</summary>
    private static TextureFootprint Steps(double u, double v)
    {
        int choice = (int)(BitConverter.DoubleToInt64Bits(u) ^ (BitConverter.DoubleToInt64Bits(u) >> 52) ^ (BitConverter.DoubleToInt64Bits(v) >> 3)) & 7;
        return choice < 2 ? default : new TextureFootprint(Math.ScaleB(1, choice - 9), Math.ScaleB(-0.75, choice - 9), 0.0078125, 0.015625);
    }

    /// <summary>The same lookups with footprints: points, boxes along the axes, thin and long ones, huge ones; floats, as batches hold them.</summary>
    public static TextureLookup[] FootprintLookups(TextureWrap wrapU, TextureWrap wrapV)
    {
        float[] steps = [0, 0.25f, -0.125f, 1e-3f, 0.7f, 3.3f, -1e-9f, 40, 1e12f];
        float Step(int i) => steps[i % steps.Length];
        return [.. Lookups(wrapU, wrapV).Select((lookup, i) => lookup with
        {
            Footprint = new TextureFootprint(Step(i), Step(i / 2), Step(i / 3), Step(i / 5)),
            LocalFootprint = new SurfaceFootprint(new Vector3D(Step(i), Step(i / 2), Step(i / 4)), new Vector3D(Step(i / 3), Step(i / 5), Step(i / 7))),
        })];
    }

    /// <summary>Colours of lookups that share their wraps, through the batch door.</summary>
    public static Intensity[] Sample<R, F, I>(TextureSampler sampler, TextureLookup[] lookups)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        LaneColumn<R> Column(Func<TextureLookup, double> number) => new([.. lookups.Select(number)]);
        using LaneColumn<R> u = Column(l => l.Coordinate.U), v = Column(l => l.Coordinate.V);
        using LaneColumn<R> x = Column(l => l.LocalPoint.X), y = Column(l => l.LocalPoint.Y), z = Column(l => l.LocalPoint.Z);
        using LaneColumn<R> nx = Column(l => l.LocalNormal.X), ny = Column(l => l.LocalNormal.Y), nz = Column(l => l.LocalNormal.Z);
        using LaneColumn<R> wx = Column(l => l.WorldPoint.X), wy = Column(l => l.WorldPoint.Y), wz = Column(l => l.WorldPoint.Z);
        using LaneColumn<R> wnx = Column(l => l.WorldNormal.X), wny = Column(l => l.WorldNormal.Y), wnz = Column(l => l.WorldNormal.Z);
        using LaneMemory memory = new();
        FootprintColumns footprints = new(memory, lookups.Length + 16);
        int rounded = (lookups.Length + 15) / 16 * 16;
        LocalFootprintColumns Steps(Func<TextureLookup, SurfaceFootprint> step)
        {
            LocalFootprintColumns columns = new((float*)memory.Column<Float16>(6 * rounded, Float16.Width), rounded);
            for (int i = 0; i < lookups.Length; i++)
            {
                (Vector3D right, Vector3D down) = (step(lookups[i]).DpDx, step(lookups[i]).DpDy);
                (columns.XDx[i], columns.YDx[i], columns.ZDx[i]) = ((float)right.X, (float)right.Y, (float)right.Z);
                (columns.XDy[i], columns.YDy[i], columns.ZDy[i]) = ((float)down.X, (float)down.Y, (float)down.Z);
            }

            return columns;
        }

        for (int i = 0; i < lookups.Length; i++)
        {
            footprints.Put(i, lookups[i].Footprint);
        }

        using LaneColumn<F> red = new(lookups.Length), green = new(lookups.Length), blue = new(lookups.Length);
        LookupBatch<R> batch = new()
        {
            Coordinates = new CoordinateBatch<R> { U = u.Lanes, V = v.Lanes },
            Positions = new PositionBatch<R> { X = x.Lanes, Y = y.Lanes, Z = z.Lanes, NormalX = nx.Lanes, NormalY = ny.Lanes, NormalZ = nz.Lanes, WorldX = wx.Lanes, WorldY = wy.Lanes, WorldZ = wz.Lanes, WorldNormalX = wnx.Lanes, WorldNormalY = wny.Lanes, WorldNormalZ = wnz.Lanes },
            Footprints = footprints,
            LocalFootprints = Steps(lookup => lookup.LocalFootprint),
            WorldFootprints = Steps(lookup => lookup.WorldFootprint),
            WrapU = lookups[0].WrapU,
            WrapV = lookups[0].WrapV,
            Count = lookups.Length,
        };
        sampler.Sample<R, F, I>(batch, new ColorColumns<F> { R = red.Lanes, G = green.Lanes, B = blue.Lanes }, u.Packets);
        return [.. Enumerable.Range(0, lookups.Length).Select(i => new Intensity((float)red[i], (float)green[i], (float)blue[i]))];
    }

    /// <summary>Fails unless the batch door gives the bits of <see cref="ITexture.Sample"/> at every width.</summary>
    public static void SameAsScalar(ITexture texture, TextureWrap wrapU, TextureWrap wrapV) => SameAsScalar(texture, Lookups(wrapU, wrapV));

    /// <summary>The same for any lookups that share their wraps.</summary>
    public static void SameAsScalar(ITexture texture, TextureLookup[] lookups)
    {
        TextureSampler sampler = ((IPreparedTexture)texture).Prepare(TextureUse.Color, filter: null);
        Intensity[] expected = [.. lookups.Select(lookup => texture.Sample(lookup))];
        Same(expected, Sample<Double1, Float1, Int1>(sampler, lookups), lookups);
        Same(expected, Sample<Double4, Float4, Int4>(sampler, lookups), lookups);
        Same(expected, Sample<Double8, Float8, Int8>(sampler, lookups), lookups);
        Same(expected, Sample<Double16, Float16, Int16>(sampler, lookups), lookups);
        Intensity[] single = Sample<Float1, Float1, Int1>(sampler, lookups);
        Same(single, Sample<Float4, Float4, Int4>(sampler, lookups), lookups);
        Same(single, Sample<Float8, Float8, Int8>(sampler, lookups), lookups);
        Same(single, Sample<Float16, Float16, Int16>(sampler, lookups), lookups);
    }

    private static void Same(Intensity[] expected, Intensity[] actual, TextureLookup[] lookups)
    {
        for (int i = 0; i < expected.Length; i++)
        {
            Assert.True(expected[i] == actual[i], $"At {lookups[i].Coordinate}: expected {expected[i]}, got {actual[i]}.");
        }
    }
}
