namespace LabRaytracer.Tests;

/// <summary>A torus with bumps, of quads cut in two.</summary>
internal sealed class MeshTorus
{
    private readonly List<double> _positions = [], _normals = [], _coordinates = [];
    private readonly List<int> _corners = [];

    public MeshTorus(int across, int around)
    {
        for (int i = 0; i <= across; i++)
        {
            for (int k = 0; k <= around; k++)
            {
                AddVertex(i / (double)across, k / (double)around);
                if (i < across && k < around)
                {
                    int at = (i * (around + 1)) + k;
                    _corners.AddRange([at, at + around + 1, at + 1, at + 1, at + around + 1, at + around + 2]);
                }
            }
        }
    }

    public TriangleMesh Mesh() => new(
        _positions.ToArray(), _corners.ToArray(), new MeshOptions { Normals = _normals.ToArray(), TextureCoordinates = _coordinates.ToArray() });

    private void AddVertex(double u, double v)
    {
        (double sinU, double cosU) = Math.SinCos(2 * Math.PI * u);
        (double sinV, double cosV) = Math.SinCos(2 * Math.PI * v);
        double tube = 0.4 * (1 + (0.06 * Math.Sin(2 * Math.PI * 40 * u) * Math.Sin(2 * Math.PI * 20 * v)));
        double ring = 1 + (tube * cosV);
        _positions.AddRange([ring * sinU, tube * sinV, ring * cosU]);
        _normals.AddRange([cosV * sinU, sinV, cosV * cosU]);
        _coordinates.AddRange([u, v]);
    }
}
