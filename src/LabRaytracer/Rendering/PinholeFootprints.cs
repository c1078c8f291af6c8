using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Steps on surfaces that a pinhole camera sees, straight from how its picture lies in space.</summary>
/// <remarks>
/// <para>Nobody needs the changes of unit directions: what lies along the ray vanishes in the tangent plane of the hit anyway. With D' the change of the direction as it is
/// before it is made 1 long, the step is q - d (n . q) / (n . d) with q = t (d . f) D', d . f being what made the direction 1 long.</para>
/// <para>In float lanes, but for the cosine between ray and surface, which may be small.</para>
/// </remarks>
internal static unsafe class PinholeFootprints
{
    /// <summary>Steps on the surfaces of a group of hits.</summary>
    /// <param name="camera">How the picture lies in space.</param>
    /// <param name="rays">The camera's rays.</param>
    /// <param name="t">Their hits' ray parameters.</param>
    /// <param name="order">The numbers of the rays, padded to whole groups of lanes.</param>
    /// <param name="count">How many.</param>
    /// <param name="normals">Normals of the surfaces, towards the viewer, in that order.</param>
    /// <param name="right">Receives the steps over a sample to the right.</param>
    /// <param name="down">Receives the steps over a sample down.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Step<R, F, I>(
        in PinholeSteps camera, RayBatch<R, F, I> rays, R* t, int* order, int count, in VectorColumns<R> normals, in VectorColumns<F> right, in VectorColumns<F> down)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R* directionX = rays.DirectionX, directionY = rays.DirectionY, directionZ = rays.DirectionZ;
        F forwardX = F.Of(camera.Forward.X), forwardY = F.Of(camera.Forward.Y), forwardZ = F.Of(camera.Forward.Z);
        F rightX = F.Of(camera.Right.X), rightY = F.Of(camera.Right.Y), rightZ = F.Of(camera.Right.Z);
        F downX = F.Of(camera.Down.X), downY = F.Of(camera.Down.Y), downZ = F.Of(camera.Down.Z);
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            run.Collect<R, F>(directionX, directionY, directionZ, out R dx, out R dy, out R dz);
            R wideX = normals.X[packet], wideY = normals.Y[packet], wideZ = normals.Z[packet];

            // Normals point to the viewer: the product is negative.
            F approach = R.ToSingle(R.Min(Lane.Dot(wideX, wideY, wideZ, dx, dy, dz), R.Of(-FootprintStage.LeastCosine)));
            F x = R.ToSingle(dx), y = R.ToSingle(dy), z = R.ToSingle(dz), nx = R.ToSingle(wideX), ny = R.ToSingle(wideY), nz = R.ToSingle(wideZ);
            F distance = R.ToSingle(run.Collect<R, F>(t)) * Lane.Dot(x, y, z, forwardX, forwardY, forwardZ), back = -distance / approach;
            F along = back * Lane.Dot(nx, ny, nz, rightX, rightY, rightZ);
            right.Store(packet, F.Fma(along, x, distance * rightX), F.Fma(along, y, distance * rightY), F.Fma(along, z, distance * rightZ));
            along = back * Lane.Dot(nx, ny, nz, downX, downY, downZ);
            down.Store(packet, F.Fma(along, x, distance * downX), F.Fma(along, y, distance * downY), F.Fma(along, z, distance * downZ));
        }
    }
}
