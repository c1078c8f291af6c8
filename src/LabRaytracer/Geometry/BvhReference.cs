using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>An item's box while a tree is built; read as two groups of four floats.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct BvhReference
{
    /// <summary>
    /// Added to item numbers: they sit in the fourth float of the first group, where the bits of a small integer would be a subnormal float,
    /// which makes every vector operation on it slow.
    /// </summary>
    private const int NormalFloat = 0x3F80_0000;

    public float MinX, MinY, MinZ;
    private int _number;
    public float MaxX, MaxY, MaxZ;
    private float _unused;

    /// <summary>Number of the item, [0, 2^30).</summary>
    public int Number
    {
        readonly get => _number - NormalFloat;
        set
        {
            _number = value + NormalFloat;
            _unused = 1;
        }
    }
}
