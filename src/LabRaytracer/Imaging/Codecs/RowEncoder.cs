using System.Buffers.Binary;
using System.Numerics;
using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>Rows of light to rows of codes (red, green, blue; 16-bit codes big-endian), as PNG and PPM store them.</summary>
/// <remarks>Immutable, thread safe.</remarks>
internal sealed class RowEncoder(TransferFunction transfer, int bitDepth, ToneMapping toneMapping, Dithering dithering = Dithering.None)
{
    private readonly OrderedDither? dither = dithering != Dithering.None && bitDepth == 8 ? new OrderedDither(transfer, dithering) : null;
    private readonly CodeTable? table = ColorEncoding.EncodeTable(transfer, bitDepth);

    /// <summary>3 or 6.</summary>
    public int BytesPerPixel { get; } = 3 * bitDepth / 8;

    /// <summary>Encodes one row.</summary>
    /// <param name="row">Its light.</param>
    /// <param name="y">Its number; only where light is dithered it matters.</param>
    /// <param name="target">Receives the codes.</param>
    public void Encode(ReadOnlySpan<Intensity> row, int y, Span<byte> target)
    {
        if (bitDepth == 16)
        {
            Encode16(row, target);
        }
        else if (dither is { } thresholds)
        {
            EncodeDithered8(row, y, target, thresholds);
        }
        else if (table is { } codes && toneMapping.IsPlainClamp)
        {
            EncodeClamped8(row, target, codes);
        }
        else if (table is null && toneMapping.IsPlainClamp)
        {
            EncodeLinear8(MemoryMarshal.Cast<Intensity, float>(row), target);
        }
        else
        {
            Encode8(row, target);
        }
    }

    /// <summary>The common case: the table clamps by itself.</summary>
    private static void EncodeClamped8(ReadOnlySpan<Intensity> row, Span<byte> target, CodeTable codes)
    {
        target = target[..(3 * row.Length)];
        for (int x = 0, i = 0; x < row.Length; x++, i += 3)
        {
            Intensity light = row[x];
            target[i] = (byte)codes.Encode(light.R);
            target[i + 1] = (byte)codes.Encode(light.G);
            target[i + 2] = (byte)codes.Encode(light.B);
        }
    }

    /// <summary><see cref="ColorEncoding.Linear8FromLinear"/> of many components.</summary>
    private static void EncodeLinear8(ReadOnlySpan<float> light, Span<byte> target)
    {
        int i = 0;
        for (; i <= light.Length - Vector<byte>.Count; i += Vector<byte>.Count)
        {
            ReadOnlySpan<float> part = light.Slice(i, Vector<byte>.Count);
            Vector<short> low = Vector.Narrow(LinearCodes(part), LinearCodes(part[Vector<float>.Count..]));
            Vector<short> high = Vector.Narrow(LinearCodes(part[(2 * Vector<float>.Count)..]), LinearCodes(part[(3 * Vector<float>.Count)..]));
            Vector.AsVectorByte(Vector.Narrow(low, high)).CopyTo(target[i..]);
        }

        for (; i < light.Length; i++)
        {
            target[i] = ColorEncoding.Linear8FromLinear(light[i]);
        }
    }

    private static Vector<int> LinearCodes(ReadOnlySpan<float> part)
    {
        Vector<float> light = new(part);
        light = Vector.ConditionalSelect(Vector.GreaterThan(light, Vector<float>.Zero), light, Vector<float>.Zero);
        light = Vector.ConditionalSelect(Vector.LessThan(light, Vector<float>.One), light, Vector<float>.One);
        Vector.Widen(light, out Vector<double> low, out Vector<double> high);
        Vector<double> max = new(255), half = new(0.5);
        return Vector.ConvertToInt32(Vector.Narrow(Vector.Floor((low * max) + half), Vector.Floor((high * max) + half)));
    }

    private void EncodeDithered8(ReadOnlySpan<Intensity> row, int y, Span<byte> target, OrderedDither thresholds)
    {
        for (int x = 0; x < row.Length; x++)
        {
            Intensity light = toneMapping.Apply(row[x]);
            float threshold = thresholds.ThresholdAt(x, y);
            target[3 * x] = thresholds.Code(light.R, threshold);
            target[(3 * x) + 1] = thresholds.Code(light.G, threshold);
            target[(3 * x) + 2] = thresholds.Code(light.B, threshold);
        }
    }

    private void Encode8(ReadOnlySpan<Intensity> row, Span<byte> target)
    {
        for (int x = 0; x < row.Length; x++)
        {
            Intensity light = toneMapping.Apply(row[x]);
            target[3 * x] = Code8(light.R);
            target[(3 * x) + 1] = Code8(light.G);
            target[(3 * x) + 2] = Code8(light.B);
        }
    }

    private void Encode16(ReadOnlySpan<Intensity> row, Span<byte> target)
    {
        for (int x = 0; x < row.Length; x++)
        {
            Intensity light = toneMapping.Apply(row[x]);
            BinaryPrimitives.WriteUInt16BigEndian(target[(6 * x)..], Code16(light.R));
            BinaryPrimitives.WriteUInt16BigEndian(target[((6 * x) + 2)..], Code16(light.G));
            BinaryPrimitives.WriteUInt16BigEndian(target[((6 * x) + 4)..], Code16(light.B));
        }
    }

    private byte Code8(float light) => (byte)(table?.Encode(light) ?? ColorEncoding.LinearCode(light, 255));

    private ushort Code16(float light) => (ushort)(table?.Encode(light) ?? ColorEncoding.LinearCode(light, 65535));
}
