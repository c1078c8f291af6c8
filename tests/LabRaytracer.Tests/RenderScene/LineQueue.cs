using System.Text;
using System.Threading.Channels;

namespace LabRaytracer.Tests.Samples;

/// <summary>Lines that one thread writes and another waits for.</summary>
internal sealed class LineQueue : TextWriter
{
    private readonly Channel<string> _lines = Channel.CreateUnbounded<string>();

    public override Encoding Encoding => Encoding.UTF8;

    public override void WriteLine(string? value) => _lines.Writer.TryWrite(value ?? "");

    /// <summary>Takes lines up to the first that contains a word.</summary>
    public async Task Until(string word)
    {
        while (!(await _lines.Reader.ReadAsync()).Contains(word, StringComparison.Ordinal))
        {
        }
    }
}
