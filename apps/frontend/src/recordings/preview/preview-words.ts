import { counted } from '@ubii/words';
import type { PreviewState } from './preview-store.ts';

/** A preview in words, for readers that do not see it; undefined until it is known. */
export function previewText(state: PreviewState | undefined): string | undefined {
  if (state?.problem !== undefined) return `No preview. ${state.problem}`;
  if (state?.preview === undefined) return undefined;
  const { tracks, markers, records } = state.preview;
  if (records === 0) return 'No records';
  const names = tracks.map(({ label }) => label).join(', ');
  const marked = markers.length > 0 ? ` ${counted(markers.length, 'marker')}.` : '';
  return `Most records: ${names}.${marked}`;
}
