using System.Globalization;
using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>Chooses how packed texels are read.</summary>
internal static unsafe class PictureSamplers
{
    /// <summary>The sampler of a store.</summary>
    /// <param name="store">Packed texels.</param>
    /// <param name="use">What is read of it.</param>
    /// <param name="options">How the texture is looked up.</param>
    /// <param name="filter">Filter, overrides the options' one.</param>
    public static TextureSampler Create(TexelStore store, TextureUse use, SamplingOptions options, TextureFilter filter)
    {
        TextureSampler sampler = Inside(store, use, options, filter);
        return use is TextureUse.Color or TextureUse.Data && options.BorderColor != Intensity.Black ? new BorderSampler(sampler, options) : sampler;
    }

    /// <summary>The sampler of a store, black outside of a border.</summary>
    private static TextureSampler Inside(TexelStore store, TextureUse use, SamplingOptions options, TextureFilter filter)
    {
        switch (use)
        {
            case TextureUse.Alpha:
                return Alpha(store, options, filter);
            case TextureUse.Premultiplied when store.Facts.HasAlpha:
                return Premultiplied(store, options, filter);
        }

        bool isData = use == TextureUse.Data;
        TransferFunction transfer = Transfer(store, isData, options.ColorSpace);
        return filter == TextureFilter.Bilinear && store.Packed is not null && IsUsual(store, options)
            ? Packed(store, store.Packed, transfer, options, () => OfRows(store, transfer, isData, options, filter))
            : OfRows(store, transfer, isData, options, filter);
    }

    /// <summary>Tells whether both axes of a picture are usual ones, as far as that does not depend on the mapping.</summary>
    private static bool IsUsual(TexelStore store, SamplingOptions options) =>
        TexelPairs.Fits(new(store.Width, options.WrapU ?? TextureWrap.Repeat, options.Texels))
        && TexelPairs.Fits(new(store.Height, options.WrapV ?? TextureWrap.Repeat, options.Texels));

    private static TextureSampler Packed(TexelStore store, PackedTexels packed, TransferFunction transfer, SamplingOptions options, Func<TextureSampler> rows)
    {
        if (transfer.IsLinear)
        {
            return new PictureSampler<PackedLinearReader>(store, null, new PackedLinearReader(packed.Texels), options, TextureFilter.Bilinear, rows);
        }

        float[] table = Table(store, transfer, out nint address);
        return new PictureSampler<PackedTableReader>(store, table, new PackedTableReader(packed.Texels, (float*)address), options, TextureFilter.Bilinear, rows);
    }

    private static TextureSampler OfRows(TexelStore store, TransferFunction transfer, bool isData, SamplingOptions options, TextureFilter filter)
    {
        return store.Facts.Format switch
        {
            PixelFormat.Rgba8 when transfer.IsLinear =>
                Sampler(store, null, new Linear8Reader((int*)store.Samples), isData, options, filter),
            PixelFormat.Rgba8 => WithTable(store, transfer, (texels, table) => new Table8Reader((int*)texels, (float*)table), isData, options, filter),
            PixelFormat.Rgba16 => WithTable(store, transfer, (texels, table) => new Table16Reader((int*)texels, (float*)table), isData, options, filter),
            _ => Sampler(store, null, new FloatReader((float*)store.Samples), isData, options, filter),
        };
    }

    /// <summary>Linear light of every code; empty for float samples.</summary>
    public static ReadOnlySpan<float> DecodeTable(TexelStore store, bool isData, ColorSpace colorSpace) => store.Facts.Format == PixelFormat.RgbaFloat
        ? default
        : ColorEncoding.DecodeTable(Transfer(store, isData, colorSpace), store.Facts.Format);

    private static TextureSampler Alpha(TexelStore store, SamplingOptions options, TextureFilter filter) => store.Facts.Format switch
    {
        PixelFormat.Rgba8 => Sampler(store, null, new Alpha8Reader((int*)store.Samples), isData: false, options, filter),
        PixelFormat.Rgba16 => Sampler(store, null, new Alpha16Reader((int*)store.Samples), isData: false, options, filter),
        _ => Sampler(store, null, new AlphaFloatReader((float*)store.Samples), isData: false, options, filter),
    };

    private static TextureSampler Premultiplied(TexelStore store, SamplingOptions options, TextureFilter filter)
    {
        TransferFunction transfer = Transfer(store, isData: false, options.ColorSpace);
        return store.Facts.Format switch
        {
            PixelFormat.Rgba8 => WithTable(
                store,
                transfer,
                (texels, table) => new PremultipliedReader<Table8Reader, Alpha8Reader>(new((int*)texels, (float*)table), new((int*)texels)),
                isData: false,
                options,
                filter),
            PixelFormat.Rgba16 => WithTable(
                store,
                transfer,
                (texels, table) => new PremultipliedReader<Table16Reader, Alpha16Reader>(new((int*)texels, (float*)table), new((int*)texels)),
                isData: false,
                options,
                filter),
            _ => Sampler(
                store,
                null,
                new PremultipliedReader<FloatReader, AlphaFloatReader>(new((float*)store.Samples), new((float*)store.Samples)),
                isData: false,
                options,
                filter),
        };
    }

    /// <summary>How the codes of a store become light in colour slots, and who says so.</summary>
    public static string Rule(TexelStore store, ColorSpace colorSpace) => string.Create(
        CultureInfo.InvariantCulture, $"{Transfer(store, isData: false, colorSpace)} ({(colorSpace == ColorSpace.Auto ? store.Facts.TransferSource : "asked for")})");

    private static TransferFunction Transfer(TexelStore store, bool isData, ColorSpace colorSpace) => colorSpace switch
    {
        ColorSpace.Srgb => TransferFunction.Srgb,
        ColorSpace.Linear => TransferFunction.Linear,
        _ => isData ? TransferFunction.Linear : store.Facts.Transfer,
    };

    private static TextureSampler Sampler<TReader>(TexelStore store, float[]? table, TReader reader, bool isData, SamplingOptions options, TextureFilter filter)
        where TReader : struct, ITexelReader
    {
        MipPyramid Pyramid(int margin = 0) =>
            store.Pyramid((typeof(TReader), isData, options.ColorSpace, margin), () => new MipPyramid(new ReaderRows<TReader>(store, table, reader), margin));
        return filter switch
        {
            TextureFilter.CatmullRom or TextureFilter.BSpline => new BicubicSampler<TReader>(store, table, reader, options, filter, isData),
            TextureFilter.Trilinear => new TrilinearSampler<TReader>(store, table, reader, options, Pyramid()),
            TextureFilter.Ewa => new EwaSampler<TReader>(store, table, reader, options, Pyramid(EwaSampler<TReader>.Margin)),
            TextureFilter.Area => new AreaSampler<TReader>(store, table, reader, options, Pyramid()),
            _ => new PictureSampler<TReader>(store, table, reader, options, filter),
        };
    }

    private static TextureSampler WithTable<TReader>(
        TexelStore store, TransferFunction transfer, Func<nint, nint, TReader> reader, bool isData, SamplingOptions options, TextureFilter filter)
        where TReader : struct, ITexelReader
    {
        float[] table = Table(store, transfer, out nint address);
        return Sampler(store, table, reader((nint)store.Samples, address), isData, options, filter);
    }

    /// <summary>Linear light of every code, pinned.</summary>
    private static float[] Table(TexelStore store, TransferFunction transfer, out nint address)
    {
        ReadOnlySpan<float> codes = ColorEncoding.DecodeTable(transfer, store.Facts.Format);
        float[] table = GC.AllocateUninitializedArray<float>(codes.Length, pinned: true);
        codes.CopyTo(table);
        address = Marshal.UnsafeAddrOfPinnedArrayElement(table, 0);
        return table;
    }
}
