namespace LabRaytracer;

/// <content>From pixels to camera rays.</content>
internal sealed unsafe partial class TileWorker<R, F, I>
{
    private readonly RayBounds[] _bounds = new RayBounds[(((Pixels / R.Width) - 1) / RayBatch<R, F, I>.BundlePackets) + 1];

    /// <summary>The rectangles of the pixels' corners in the tile, bundle by bundle.</summary>
    private readonly (double Left, double Right, double Top, double Bottom)[] _rectangles =
        new (double, double, double, double)[(((Pixels / R.Width) - 1) / RayBatch<R, F, I>.BundlePackets) + 1];

    /// <summary>Where the sample of the tile's first pixel is, if samples are at the same place in all pixels.</summary>
    private (double X, double Y)? _grid;

    /// <summary>Groups of lanes that still hold the origin of all the camera's rays.</summary>
    private int _originPackets;

    private void FindRectangles()
    {
        for (int bundle = 0; bundle < _rectangles.Length; bundle++)
        {
            int first = bundle * RayBatch<R, F, I>.BundlePackets;
            _rectangles[bundle] = Rectangle(_pixelX, _pixelY, first, Math.Min(first + RayBatch<R, F, I>.BundlePackets, Pixels / R.Width));
        }
    }

    /// <summary>Camera rays of one sample of every pixel; pixels outside the picture are off.</summary>
    private void Aim(int x, int y, int sample)
    {
        if (_places.IsSame)
        {
            PlaceSamples(x, y, _places.At(x, y, sample, 0), _places.At(x, y, sample, 1));
        }
        else
        {
            _grid = null;
            ulong first = ((ulong)(uint)x << 32) | (uint)y;
            _places.Fill(_places.Axis(sample, 0), _pixelNumbers, first, _samplePlaces, Pixels);
            Shift(_pixelX, x, _samplePlaces, _sampleX);
            _places.Fill(_places.Axis(sample, 1), _pixelNumbers, first, _samplePlaces, Pixels);
            Shift(_pixelY, y, _samplePlaces, _sampleY);
        }

        AimSamples(x, y);
    }

    /// <summary>From places in pixels to places in the picture, by sums of doubles.</summary>
    private static void Shift(R* pixels, int start, double* places, R* samples)
    {
        if (R.IsSingle)
        {
            for (int i = 0; i < Pixels; i++)
            {
                R.Put(samples, i, R.Take(pixels, i) + start + places[i]);
            }

            return;
        }

        R left = R.Of(start);
        for (int packet = 0; packet < Pixels / R.Width; packet++)
        {
            samples[packet] = pixels[packet] + left + ((R*)places)[packet];
        }
    }

    /// <summary>Puts the samples at the same place in all pixels. Pixels are counted before that is added, so that a sample's place does not depend on the tile, to the last bit.</summary>
    private void PlaceSamples(int x, int y, double rightwards, double downwards)
    {
        _grid = (x + rightwards, y + downwards);
        R left = R.Of(x), top = R.Of(y), right = R.Of(rightwards), down = R.Of(downwards);
        for (int packet = 0; packet < Pixels / R.Width; packet++)
        {
            _sampleX[packet] = _pixelX[packet] + left + right;
            _sampleY[packet] = _pixelY[packet] + top + down;
        }
    }

    private void AimSamples(int x, int y)
    {
        _rays.Count = Pixels;
        AimCamera(_options.Samples);
        if (x + Side <= _area.X + _area.Width && y + Side <= _area.Y + _area.Height)
        {
            new Span<R>(_rays.Limit, Pixels / R.Width).Fill(R.Of(double.PositiveInfinity));
            return;
        }

        R right = R.Of(_area.X + _area.Width - x), bottom = R.Of(_area.Y + _area.Height - y);
        for (int packet = 0; packet < Pixels / R.Width; packet++)
        {
            R inside = R.Less(_pixelX[packet], right) & R.Less(_pixelY[packet], bottom);
            _rays.Limit[packet] = R.Select(inside, R.Of(double.PositiveInfinity), R.Of(-1));
        }
    }

    /// <param name="samples">Samples of a pixel; their footprints share it.</param>
    private void AimCamera(int samples)
    {
        AimRays();
        _rays.Bounds = _lens is null && _scene.IsSkipping ? FindBounds() : null;
        _lens?.Run(_rays, _sampleX, _sampleY, _options);
        if (_rays.HasDifferentials)
        {
            CameraDifferentials.Set(_scene.Camera, _rays, _sampleX, _sampleY, _options, samples);
        }
    }

    /// <summary>Bounds of the camera's rays, bundle by bundle, from where they pass the picture; null if the camera does not know them.</summary>
    private RayBounds[]? FindBounds()
    {
        const int Bundle = RayBatch<R, F, I>.BundlePackets;
        for (int first = 0; first < _rays.Packets; first += Bundle)
        {
            (double left, double right, double top, double bottom) = _grid is { } start
                ? Moved(_rectangles[first / Bundle], start.X, start.Y)
                : Rectangle(_sampleX, _sampleY, first, Math.Min(first + Bundle, _rays.Packets));
            if ((_scene.Camera as IWideCamera)?.Bounds(left, right, top, bottom, _options.Width, _options.Height) is not { } bounds)
            {
                return null;
            }

            _bounds[first / Bundle] = bounds;
        }

        return _bounds;

        static (double Left, double Right, double Top, double Bottom) Moved((double Left, double Right, double Top, double Bottom) rectangle, double x, double y) =>
            (rectangle.Left + x, rectangle.Right + x, rectangle.Top + y, rectangle.Bottom + y);
    }

    /// <summary>The rectangle around some places.</summary>
    private static (double Left, double Right, double Top, double Bottom) Rectangle(R* x, R* y, int first, int end)
    {
        R left = x[first], right = left, top = y[first], bottom = top;
        for (int packet = first + 1; packet < end; packet++)
        {
            left = R.Min(left, x[packet]);
            right = R.Max(right, x[packet]);
            top = R.Min(top, y[packet]);
            bottom = R.Max(bottom, y[packet]);
        }

        return (Lane.Least(left), R.Largest(right), Lane.Least(top), R.Largest(bottom));
    }

    private void AimRays()
    {
        if (_scene.Camera is IWideCamera wide)
        {
            RayColumns<R> columns = _rays.Columns;
            if (wide.HasOneOrigin && _rays.Packets <= _originPackets)
            {
                columns.OriginX = columns.OriginY = columns.OriginZ = null;
            }

            _originPackets = Math.Max(_originPackets, _rays.Packets);
            wide.Rays(_sampleX, _sampleY, columns, _rays.Packets, _options.Width, _options.Height);
            return;
        }

        for (int i = 0; _lens is null && i < _rays.Count; i++)
        {
            _rays.Set(i, _scene.Camera.RayAt(R.Take(_sampleX, i), R.Take(_sampleY, i), _options.Width, _options.Height));
        }
    }
}
