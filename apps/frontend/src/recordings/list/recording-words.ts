import { RecordingState, type Recording } from '@ubii/proto';
import { counted } from '@ubii/words';
import { formatBytes } from '../../ui/readouts/format-bytes.ts';
import { formatClock, formatDay } from '../../ui/readouts/format-clock.ts';
import type { MarkedState } from '../../ui/UiStateMark.vue';
import { formatLength } from '../timeline/recording-time.ts';

/** How a recording is, as a mark and a word. */
export interface RecordingLook {
  readonly mark: MarkedState;
  readonly word: string;
}

export const isRunning = ({ state }: Pick<Recording, 'state'>): boolean =>
  state === RecordingState.RECORDING_STATE_RECORDING;

/** Its file is still on the node that recorded it. [RC-63] */
export const isAtNode = ({ state }: Pick<Recording, 'state'>): boolean =>
  state === RecordingState.RECORDING_STATE_AT_NODE;

/** Its file was refused, and can only be deleted. [RC-45] */
export const isRejected = ({ state }: Pick<Recording, 'state'>): boolean =>
  state === RecordingState.RECORDING_STATE_REJECTED;

/** Where a recording of a node is, in one sentence. */
export function placeSentence(recording: Recording): string {
  const { nodeName, nodeIsAway, uploadedBytes, sizeBytes, problem } = recording;
  if (isRunning(recording)) {
    return nodeIsAway
      ? `${nodeName}, which records it, is not connected. It goes on when it returns.`
      : `Recorded by ${nodeName}.`;
  }
  if (nodeIsAway) {
    return `The file is on ${nodeName}, which is not connected. It is uploaded when it returns.`;
  }
  if (uploadedBytes > 0 && sizeBytes > 0) {
    const percent = Math.min(100, Math.floor((uploadedBytes / sizeBytes) * 100));
    return `The file is on ${nodeName}, and ${percent} % of it is uploaded.`;
  }
  return problem === ''
    ? `The file is on ${nodeName}, and waits to be uploaded.`
    : `The file is on ${nodeName}.`;
}

/** Undefined for one that is as it should be. */
export function recordingLook(recording: Recording): RecordingLook | undefined {
  const { state, lostCount, nodeName, nodeIsAway, problem } = recording;
  switch (state) {
    case RecordingState.RECORDING_STATE_RECORDING:
      return nodeIsAway ? { mark: 'away', word: `${nodeName} is away` } : undefined;
    case RecordingState.RECORDING_STATE_AT_NODE:
      return nodeIsAway || problem !== ''
        ? { mark: 'warning', word: `On ${nodeName}` }
        : { mark: 'live', word: `Uploading from ${nodeName}` };
    case RecordingState.RECORDING_STATE_REPAIRED:
      return { mark: 'warning', word: 'Repaired' };
    case RecordingState.RECORDING_STATE_FAILED:
      return { mark: 'error', word: 'Stopped early' };
    case RecordingState.RECORDING_STATE_REJECTED:
      return { mark: 'error', word: 'Cannot be read' };
    default:
      return lostCount > 0
        ? { mark: 'warning', word: `${counted(lostCount, 'record')} missing` }
        : undefined;
  }
}

const DAYS = ['Sunday', 'Monday', 'Tuesday', 'Wednesday', 'Thursday', 'Friday', 'Saturday'];
const DAY_MS = 86_400_000;

/** When it was made, as short as people say it: `today 14:02`, `Friday 20:40`, `2 Jan 2026 12:41`. */
export function formatWhen(timeMs: number, nowMs: number): string {
  const clock = formatClock(timeMs, 'minute');
  const days = Math.round((startOfDay(nowMs) - startOfDay(timeMs)) / DAY_MS);
  if (days === 0) return `today ${clock}`;
  if (days === 1) return `yesterday ${clock}`;
  if (days > 1 && days < 7) return `${DAYS[new Date(timeMs).getDay()]!} ${clock}`;
  return `${formatDay(timeMs)} ${clock}`;
}

const startOfDay = (timeMs: number): number => new Date(timeMs).setHours(0, 0, 0, 0);

/** A size in one word: `212 MB`. */
export function sizeText(bytes: number): string {
  const { digits, unit } = formatBytes(bytes);
  return `${digits} ${unit ?? ''}`;
}

/** Recordings whose name, notes or author has all words of a search. */
export function findRecordings(all: readonly Recording[], search: string): readonly Recording[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return all;
  return all.filter(({ name, notes, author }) => {
    const text = `${name} ${notes} ${author}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
}

/** In which order the list is. */
export type RecordingOrder = 'newest' | 'name' | 'longest' | 'largest';

export const RECORDING_ORDERS: readonly {
  readonly value: RecordingOrder;
  readonly text: string;
}[] = [
  { value: 'newest', text: 'Newest first' },
  { value: 'name', text: 'By name' },
  { value: 'longest', text: 'Longest first' },
  { value: 'largest', text: 'Largest first' },
];

/** @param all the newest first */
export function sortRecordings(
  all: readonly Recording[],
  order: RecordingOrder,
): readonly Recording[] {
  switch (order) {
    case 'newest':
      return all;
    case 'name':
      return all.toSorted((a, b) => a.name.localeCompare(b.name, undefined, { numeric: true }));
    case 'longest':
      return all.toSorted((a, b) => b.durationMs - a.durationMs);
    case 'largest':
      return all.toSorted((a, b) => b.sizeBytes - a.sizeBytes);
  }
}

/**
 * What the master estimates, in one or two sentences.
 *
 * @param freeBytes of the disk of the master
 * @param nodeName of the node that records; undefined: the master does
 */
export function estimateSentence(
  recordsPerSecond: number,
  bytesPerSecond: number,
  freeBytes: number,
  nodeName?: string,
): string {
  if (recordsPerSecond === 0)
    return 'Nothing that was selected is published now. Topics that appear later are recorded.';
  const rate = `${counted(Math.round(recordsPerSecond), 'record')} and ${sizeText(bytesPerSecond)} per second before compression.`;
  if (nodeName !== undefined)
    return `${rate} The recording stops before the disk of ${nodeName} is full.`;
  if (freeBytes <= 0 || bytesPerSecond <= 0) return rate;
  const hours = freeBytes / bytesPerSecond / 3600;
  const room = hours >= 48 ? 'more than two days' : formatLength(hours * 3_600_000);
  return `${rate} The disk has room for ${hours >= 48 ? room : `at least ${room}`}.`;
}

const OF_OTHERS = 'Recordings of others are shown to admins only.';

/** What an empty list says. [RC-66] */
export function emptySentence(mayRecord: boolean, isNoAdmin: boolean): string {
  const drop = mayRecord
    ? 'Keep what the flight recorder holds, record what comes next, or drop a file on this page: MCAP, CSV or XDF.'
    : 'Drop a file on this page to read it on this device: MCAP, CSV or XDF.';
  return `Recordings appear here. ${drop}${isNoAdmin ? ` ${OF_OTHERS}` : ''}`;
}

/** What the page of a recording says that is not in the list. */
export function unknownSentence(isNoAdmin: boolean): string {
  const sentence = 'No recording with this address. It may have been deleted.';
  return isNoAdmin ? `${sentence} ${OF_OTHERS}` : sentence;
}
