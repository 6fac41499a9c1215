import {
  ButtonEventType,
  DATA_FORMATS,
  TouchEventType,
  type DataFormat,
  type TopicRecord,
} from '@ubii/proto';
import { formatValue } from '../../topics/values/format-value.ts';
import { seriesOf, sparkNumbers } from '../../topics/values/value-series.ts';

/** How a track is drawn. */
export type TrackKind = 'lines' | 'ticks' | 'frames' | 'bars' | 'text' | 'bytes';

/** What one record adds to its track. */
export interface TrackEntry {
  /** One for each line; NaN where there is none. */
  readonly numbers: readonly number[];
  /** What holds from now on until the next record says otherwise: the text, things seen, keys held. */
  readonly states: readonly string[] | undefined;
}

/** The longest text of a bar, characters. */
const MAX_BAR_TEXT = 60;
const NO_NUMBERS: readonly number[] = [];

/** How records of a format are drawn over time. */
export function trackKind(format: DataFormat | undefined): TrackKind {
  if (format === undefined) return 'bytes';
  const { family } = DATA_FORMATS[format];
  if (family === 'image') return 'frames';
  if (family === 'objects') return 'bars';
  if (family === 'event') return 'ticks';
  if (family === 'number' || seriesOf(format) !== undefined) return 'lines';
  return family === 'text' ? 'text' : 'bytes';
}

/** What a record adds to a track of its format. */
export function entryOf(record: TopicRecord): TrackEntry {
  const kind = trackKind(record.format);
  const numbers = kind === 'lines' ? sparkNumbers(record.format, record.value) : NO_NUMBERS;
  return { numbers, states: statesOf(record, kind) };
}

function statesOf(record: TopicRecord, kind: TrackKind): readonly string[] | undefined {
  if (kind === 'text')
    return [formatValue(record.format, record.value as never).slice(0, MAX_BAR_TEXT)];
  if (kind === 'bars') return namesOf(record);
  return kind === 'ticks' ? heldIn(record) : undefined;
}

/** Things are distinguished by id, those without one by their place in the list. */
function namesOf(record: TopicRecord): readonly string[] {
  switch (record.format) {
    case 'object2D':
    case 'object3D':
      return [record.value.id || 'object'];
    case 'object2DList':
    case 'object3DList':
      return [
        ...new Set(record.value.elements.map(({ id }, index) => id || `object ${index + 1}`)),
      ];
    default:
      return [];
  }
}

/** What is held down after an event. */
function heldIn(record: TopicRecord): readonly string[] | undefined {
  switch (record.format) {
    case 'bool':
      return record.value ? ['on'] : [];
    case 'touchEvent':
      return record.value.type === TouchEventType.TOUCH_END ? [] : ['touch'];
    case 'keyEvent':
      return record.value.type === ButtonEventType.DOWN ? [record.value.key] : [];
    case 'mouseEvent':
      return record.value.type === ButtonEventType.DOWN ? [`button ${record.value.button}`] : [];
    default:
      return undefined;
  }
}
