namespace LabRaytracer;

/// <summary>Finds the pixels of a tile near which an edge passes: where objects meet, surfaces hide parts of themselves, or turn sharply.</summary>
/// <remarks>
/// <para>What is seen at the corners of all pixels is compared, corner by corner, those beyond the tile too: so what is marked depends neither on tiles nor on crops.
/// Edges that no corner of a pixel tells apart, such as of a wire between them, are not found.</para>
/// <para>On a plane the inverse of the distance changes evenly from corner to corner, up to second order of a pixel's angle, however steeply it is seen. So a surface hides
/// a part of itself where the inverse takes a step that neither the step before nor the one behind lets expect.</para>
/// <para>A pixel is marked if an edge passes through any pixel that its filter reaches.</para>
/// </remarks>
/// <param name="side">Width and height of the tile, pixels.</param>
/// <param name="reach">How many pixels to each side of a pixel its filter reaches.</param>
internal sealed class EdgeMarks(int side, int reach)
{
    /// <summary>Most that a step of the inverse distance may differ from its neighbours, of the inverse distance.</summary>
    private const double InverseStep = 1.0 / 32;

    /// <summary>Cosine of the angle that a surface may turn by from corner to corner: 11.5 degrees.</summary>
    private const double TurnCosine = 0.98;

    private readonly int _cellSide = side + (2 * reach);
    private readonly Corner[] _corners = new Corner[(side + (2 * reach) + 3) * (side + (2 * reach) + 3)];
    private readonly bool[] _cells = new bool[(side + (2 * reach)) * (side + (2 * reach))];

    /// <summary>Number of corners: those of the pixels that are compared, and one more on each side.</summary>
    public int Count => _corners.Length;

    private int Columns => _cellSide + 3;

    /// <summary>Place of a corner, pixels from the tile's top left corner.</summary>
    public (int X, int Y) Place(int corner) => ((corner % Columns) - reach - 1, (corner / Columns) - reach - 1);

    /// <summary>Notes what is seen at a corner.</summary>
    /// <param name="corner">Number of the corner.</param>
    /// <param name="number">Number of the object, or what stands for none.</param>
    /// <param name="inverseDistance">1 / its distance; of no object 0.</param>
    /// <param name="normal">Its normal for shading, length 1; of no object 0.</param>
    public void Set(int corner, int number, double inverseDistance, Vector3D normal) => _corners[corner] = new Corner(number, inverseDistance, normal);

    /// <summary>Compares the corners; after all are set.</summary>
    public void Compare()
    {
        for (int row = 0; row < _cellSide; row++)
        {
            for (int column = 0; column < _cellSide; column++)
            {
                int corner = ((row + 1) * Columns) + column + 1;
                _cells[(row * _cellSide) + column] = Differ(corner, 1) || Differ(corner + Columns, 1) || Differ(corner, Columns) || Differ(corner + 1, Columns);
            }
        }
    }

    /// <summary>Tells whether an edge passes near a pixel; after <see cref="Compare"/>.</summary>
    /// <param name="x">Column in the tile.</param>
    /// <param name="y">Row in the tile.</param>
    public bool IsEdge(int x, int y)
    {
        for (int row = y; row <= y + (2 * reach); row++)
        {
            if (_cells.AsSpan((row * _cellSide) + x, (2 * reach) + 1).Contains(true))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Tells whether an edge passes between a corner and the next one.</summary>
    private bool Differ(int corner, int step)
    {
        ref readonly Corner one = ref _corners[corner], next = ref _corners[corner + step];
        if (one.Object != next.Object || Vector3D.Dot(one.Normal, next.Normal) < TurnCosine * one.Normal.LengthSquared)
        {
            return true;
        }

        double change = next.InverseDistance - one.InverseDistance, allowed = InverseStep * Math.Max(one.InverseDistance, next.InverseDistance);
        double before = one.InverseDistance - _corners[corner - step].InverseDistance, behind = _corners[corner + (2 * step)].InverseDistance - next.InverseDistance;
        return Math.Abs(change) > allowed && Math.Abs(change - before) > allowed && Math.Abs(change - behind) > allowed;
    }

    private readonly record struct Corner(int Object, double InverseDistance, Vector3D Normal);
}
