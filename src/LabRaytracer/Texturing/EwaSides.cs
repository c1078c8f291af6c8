using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Sides of the footprints of a group of lanes, texels of the picture. Lives on the stack.</summary>
/// <typeparam name="F">Float lanes.</typeparam>
/// <param name="memory">Room for <see cref="Size"/> groups of lanes.</param>
internal readonly unsafe struct EwaSides<F>(F* memory)
    where F : unmanaged, IReal<F>
{
    /// <summary>Groups of lanes that they take in memory.</summary>
    public const int Size = 5;

    /// <summary>The most that the longer axis of a footprint may be of the shorter one.</summary>
    private const int MaxAnisotropy = 64;

    /// <summary>Square of the longer axis; anything for footprints that are no numbers.</summary>
    public F LongerSquare
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => memory[4];
    }

    /// <summary>Reads the sides.</summary>
    /// <param name="footprints">The footprints, in units of coordinates.</param>
    /// <param name="across">Columns of the picture.</param>
    /// <param name="up">Rows of the picture.</param>
    /// <param name="packet">Number of the group.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Read(in FootprintColumns footprints, in TexelAxis across, in TexelAxis up, int packet)
    {
        // More than the whole picture is the whole picture.
        F width = F.Of(across.Size), height = F.Of(up.Size);
        F ax = Within(((F*)footprints.DuDx)[packet] * width, width), ay = Within(((F*)footprints.DvDx)[packet] * height, height);
        F bx = Within(((F*)footprints.DuDy)[packet] * width, width), by = Within(((F*)footprints.DvDy)[packet] * height, height);
        memory[0] = ax;
        memory[1] = ay;
        memory[2] = bx;
        memory[3] = by;
        memory[4] = EwaKernel.LongerSquare(ax, ay, bx, by);
    }

    /// <summary>The level, [0, last].</summary>
    /// <param name="last">The highest one.</param>
    /// <param name="isTooLong">Mask of lanes whose level is higher than their shorter axis asks for.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public F Level(int last, out F isTooLong)
    {
        F longer = memory[4], area = F.Fma(memory[0], memory[3], -(memory[1] * memory[2])), shorter = area * area / longer, least = longer * F.Of(1.0 / (MaxAnisotropy * MaxAnisotropy));
        isTooLong = F.Less(shorter, least) & F.Less(F.Of(4), least);
        F size = F.Min(shorter, F.Max(shorter * F.Of(1.0 / 4), longer * F.Of(1.0 / 256)));
        F level = F.Floor(F.Exponent(F.Max(F.Max(size, least), F.Of(1))) * F.Of(0.5));
        return F.Max(F.Min(level, F.Of(last)), F.Zero);
    }

    /// <summary>Writes the weights of texels of a level.</summary>
    /// <param name="x">Columns of the level for each of the picture.</param>
    /// <param name="y">Rows of the level for each of the picture.</param>
    /// <param name="centerX">Centre along a row, texels, from the centre of the texel to the left, [0, 1).</param>
    /// <param name="centerY">Centre across the rows, texels, from the centre of the texel below, [0, 1).</param>
    /// <param name="kernels">Receives what <see cref="EwaKernel.Store"/> writes.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(F x, F y, F centerX, F centerY, F* kernels) => EwaKernel.Store(memory[0] * x, memory[1] * y, memory[2] * x, memory[3] * y, centerX, centerY, kernels);

    /// <summary>A step no longer than the picture; what is not a number stays so.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Within(F step, F size) => F.Min(size, F.Max(-size, step));
}
