using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>The few functions of libturbojpeg that decode; its older interface, which versions 2 and 3 both have (turbojpeg.h).</summary>
internal sealed unsafe class TurboJpeg
{
    private const int PixelFormatRgba = 7;
    private const int PixelFormatCmyk = 11;
    private const int ColorSpaceCmyk = 3;
    private const int ColorSpaceYcck = 4;
    private const int FlagAccurateDct = 4096;
    private const int FlagLimitScans = 32768;
    private const int ErrorIsWarning = 0;

    private static readonly string[] FileNames =
        ["libturbojpeg.so.0", "turbojpeg", "libturbojpeg.so", "libturbojpeg.dylib", "libturbojpeg.0.dylib", "libturbojpeg.dll"];

    private readonly delegate* unmanaged<nint> initialise;
    private readonly delegate* unmanaged<nint, byte*, CULong, int*, int*, int*, int*, int> readHeader;
    private readonly delegate* unmanaged<nint, byte*, CULong, byte*, int, int, int, int, int, int> decompress;
    private readonly delegate* unmanaged<nint, byte*> errorText;
    private readonly delegate* unmanaged<nint, int> errorCode;
    private readonly delegate* unmanaged<nint, int> destroy;

    private TurboJpeg(nint library)
    {
        initialise = (delegate* unmanaged<nint>)NativeLibrary.GetExport(library, "tjInitDecompress");
        readHeader = (delegate* unmanaged<nint, byte*, CULong, int*, int*, int*, int*, int>)NativeLibrary.GetExport(library, "tjDecompressHeader3");
        decompress = (delegate* unmanaged<nint, byte*, CULong, byte*, int, int, int, int, int, int>)NativeLibrary.GetExport(library, "tjDecompress2");
        errorText = (delegate* unmanaged<nint, byte*>)NativeLibrary.GetExport(library, "tjGetErrorStr2");
        errorCode = (delegate* unmanaged<nint, int>)NativeLibrary.GetExport(library, "tjGetErrorCode");
        destroy = (delegate* unmanaged<nint, int>)NativeLibrary.GetExport(library, "tjDestroy");
    }

    /// <summary>The library, or null if the system has none or one that is too old.</summary>
    public static TurboJpeg? TryLoad()
    {
        foreach (string fileName in FileNames)
        {
            if (NativeLibrary.TryLoad(fileName, typeof(TurboJpeg).Assembly, DllImportSearchPath.SafeDirectories, out nint library))
            {
                try
                {
                    return new TurboJpeg(library);
                }
                catch (EntryPointNotFoundException)
                {
                    NativeLibrary.Free(library);
                }
            }
        }

        return null;
    }

    /// <summary>Decodes a whole file to 8-bit sRGB.</summary>
    public PixelBuffer Decode(ReadOnlySpan<byte> file, PictureLimits limits, string name)
    {
        nint handle = initialise();
        if (handle == 0)
        {
            throw new PictureFormatException(name, "libturbojpeg could not start");
        }

        try
        {
            fixed (byte* bytes = file)
            {
                return Decode(handle, bytes, new CULong((nuint)file.Length), limits, name);
            }
        }
        finally
        {
            _ = destroy(handle);
        }
    }

    private PixelBuffer Decode(nint handle, byte* bytes, CULong length, PictureLimits limits, string name)
    {
        int width;
        int height;
        int subsampling;
        int colorSpace;
        Check(handle, readHeader(handle, bytes, length, &width, &height, &subsampling, &colorSpace), name);
        limits.Check(width, height, name);
        bool isCmyk = colorSpace is ColorSpaceCmyk or ColorSpaceYcck;
        byte[] samples = new byte[4 * width * height];
        fixed (byte* target = samples)
        {
            int format = isCmyk ? PixelFormatCmyk : PixelFormatRgba;
            int flags = FlagAccurateDct | FlagLimitScans;
            Check(handle, decompress(handle, bytes, length, target, width, 4 * width, height, format, flags), name);
        }

        if (isCmyk)
        {
            ConvertCmyk(samples);
        }

        return PixelBuffer.FromRgba8(width, height, samples, TransferFunction.Srgb, "assumed for JPEG").GivenAway();
    }

    /// <summary>CMYK of JPEG files is stored inverted (255 = no ink): red = C K / 255, rounded to nearest.</summary>
    private static void ConvertCmyk(Span<byte> samples)
    {
        for (int i = 0; i < samples.Length; i += 4)
        {
            int key = samples[i + 3];
            for (int c = 0; c < 3; c++)
            {
                samples[i + c] = (byte)(((samples[i + c] * key) + 127) / 255);
            }

            samples[i + 3] = 255;
        }
    }

    private void Check(nint handle, int result, string name)
    {
        if (result == 0)
        {
            return;
        }

        string text = Marshal.PtrToStringUTF8((nint)errorText(handle)) ?? "unknown error";

        // Stray bytes between segments harm no pixel; every other warning means missing or wrong pixels.
        if (errorCode(handle) == ErrorIsWarning && text.Contains("extraneous bytes", StringComparison.OrdinalIgnoreCase))
        {
            return;
        }

        throw new PictureFormatException(name, $"the JPEG data is damaged ({text.ReplaceLineEndings(" ").TrimEnd('.')})");
    }
}
