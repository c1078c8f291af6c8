using LabRaytracer;

namespace RenderScene;

/// <summary>The pixels inside objects: they and their eight neighbours show the same object, so that no edge crosses them.</summary>
internal sealed class InnerPixels
{
    private readonly bool[] _isInner;

    /// <param name="objects">The view "object": black where nothing is.</param>
    public InnerPixels(Picture objects)
    {
        _isInner = new bool[objects.Width * objects.Height];
        for (int y = 1; y < objects.Height - 1; y++)
        {
            for (int x = 1; x < objects.Width - 1; x++)
            {
                _isInner[(y * objects.Width) + x] = objects[x, y] != Intensity.Black && AreAlike(objects, x, y);
            }
        }
    }

    /// <summary>Root mean square error of linear light over these pixels; 0 if there are none.</summary>
    public double Rmse(Picture a, Picture b)
    {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < _isInner.Length; i++)
        {
            if (_isInner[i])
            {
                sum += FrontierSweep.Square(a.Pixels[i] - b.Pixels[i]);
                count++;
            }
        }

        return Math.Sqrt(sum / (3.0 * Math.Max(count, 1)));
    }

    private static bool AreAlike(Picture objects, int x, int y)
    {
        for (int neighbor = 0; neighbor < 9; neighbor++)
        {
            if (objects[x - 1 + (neighbor % 3), y - 1 + (neighbor / 3)] != objects[x, y])
            {
                return false;
            }
        }

        return true;
    }
}
