import type { Marker } from '../records/recording-event.ts';

/** A recording lasts at least until its last marker, which may be after the last record. */
export function withMarkers(
  { startNs, endNs }: { readonly startNs: bigint; readonly endNs: bigint },
  markers: readonly Marker[],
): { readonly startNs: bigint; readonly endNs: bigint } {
  const times = markers
    .filter(({ timeMs }) => Number.isFinite(timeMs))
    .map(({ timeMs }) => BigInt(Math.round(timeMs * 1000)) * 1000n);
  const last = times.at(-1);
  if (last === undefined) return { startNs, endNs };
  return { startNs: startNs === 0n ? times[0]! : startNs, endNs: last > endNs ? last : endNs };
}
