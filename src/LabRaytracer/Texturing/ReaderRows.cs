namespace LabRaytracer;

/// <summary>Rows of packed texels.</summary>
/// <typeparam name="TReader">Reads the store's format.</typeparam>
internal sealed unsafe class ReaderRows<TReader>(TexelStore store, float[]? table, TReader reader) : TexelRows
    where TReader : struct, ITexelReader
{
    public override int Width => store.Width;

    public override int Height => store.Height;

    public override void Read(int y, float* red, float* green, float* blue)
    {
        int start = store.Start - (y * store.Width), x = 0;
        for (; x + Float8.Width <= store.Width; x += Float8.Width)
        {
            reader.Read(Int8.Iota(start + x), out Float8 r, out Float8 g, out Float8 b);
            *(Float8*)(red + x) = r;
            *(Float8*)(green + x) = g;
            *(Float8*)(blue + x) = b;
        }

        for (; x < store.Width; x++)
        {
            reader.Read(new Int1(start + x), out Float1 r, out Float1 g, out Float1 b);
            (red[x], green[x], blue[x]) = (r.Value, g.Value, b.Value);
        }

        // Pinned memory must not be collected while the reader holds raw addresses into it.
        GC.KeepAlive(store);
        GC.KeepAlive(table);
    }
}
