import { DATA_FORMATS, type DataFormat } from '@ubii/proto';
import { seriesOf } from '../values/value-series.ts';
import BytesViewer from './bytes/BytesViewer.vue';
import { CONTROLS } from './control/controls.ts';
import { EVENT_FORMATS } from '../history/event-log.ts';
import EventsViewer from './events/EventsViewer.vue';
import HistoryViewer from './HistoryViewer.vue';
import JsonViewer from './JsonViewer.vue';
import PictureViewer from './PictureViewer.vue';
import { PLANE_FORMATS } from './plane/plane-shapes.ts';
import PlaneViewer from './plane/PlaneViewer.vue';
import PlotViewer from './PlotViewer.vue';
import { isSpatial } from './space/space-things.ts';
import SpaceViewer from './space/SpaceViewer.vue';
import TableViewer from './table/TableViewer.vue';
import { TABLE_FORMATS } from './table/value-table.ts';
import type { TopicViewer } from './topic-viewer.ts';
import ValueTile from './ValueTile.vue';

/** All viewers by precedence: the first that fits a format is the best. */
export const VIEWERS: readonly TopicViewer[] = [
  {
    id: 'picture',
    title: 'Picture',
    fits: (format) => DATA_FORMATS[format].family === 'image',
    component: PictureViewer,
  },
  {
    id: 'space',
    title: '3D',
    fits: isSpatial,
    isSecond: (format) => format === 'vector3',
    component: SpaceViewer,
  },
  {
    id: 'plane',
    title: '2D',
    // Touches are shown by the events viewer.
    fits: (format) => PLANE_FORMATS.has(format) && !EVENT_FORMATS.has(format),
    isSecond: (format) => format === 'vector2',
    component: PlaneViewer,
  },
  {
    id: 'events',
    title: 'Events',
    fits: (format) => EVENT_FORMATS.has(format),
    isSecond: (format) => format === 'bool',
    component: EventsViewer,
  },
  {
    id: 'plot',
    title: 'Plot',
    fits: (format) => seriesOf(format) !== undefined,
    component: PlotViewer,
  },
  {
    id: 'table',
    title: 'Table',
    fits: (format) => TABLE_FORMATS.has(format),
    isSecond: () => true,
    component: TableViewer,
  },
  { id: 'json', title: 'JSON', fits: () => true, isSecond: () => true, component: JsonViewer },
  { id: 'bytes', title: 'Bytes', fits: () => true, isSecond: () => true, component: BytesViewer },
  {
    id: 'value',
    title: 'Value',
    fits: (format) => DATA_FORMATS[format].family !== 'image',
    isSecond: () => true,
    isInDetail: false,
    component: ValueTile,
  },
  {
    id: 'records',
    title: 'Records',
    fits: () => true,
    isSecond: () => true,
    isInDetail: false,
    component: HistoryViewer,
  },
  ...CONTROLS,
];

/** Returns the viewers that fit a data format, best first; at least one. */
export function viewersOf(format: DataFormat): readonly TopicViewer[] {
  const fitting = VIEWERS.filter((viewer) => viewer.fits(format));
  const isSecond = ({ isSecond: is }: TopicViewer): boolean => is?.(format) ?? false;
  return [
    ...fitting.filter((viewer) => !isSecond(viewer)),
    ...fitting.filter((viewer) => isSecond(viewer)),
  ];
}

/** Returns the best viewer for a data format. */
export function viewerOf(format: DataFormat): TopicViewer {
  return viewersOf(format)[0]!;
}

/** A view that can be chosen for a topic. */
export interface OfferedView {
  readonly title: string;
  /** What is stored when it is chosen: empty for the best one, which follows the format. */
  readonly viewer: string;
  readonly isShown: boolean;
}

/**
 * Returns the views that fit a format, the best first, and the one that was chosen for another format.
 * @param format `undefined` while it is unknown: all views
 * @param chosen id of a viewer; empty for the best one
 */
export function offeredViews(
  format: DataFormat | undefined,
  chosen: string,
): readonly OfferedView[] {
  const fitting = format === undefined ? VIEWERS : viewersOf(format);
  const best = format === undefined ? undefined : fitting[0];
  const other = viewerById(chosen);
  const all = other === undefined || fitting.includes(other) ? fitting : [...fitting, other];
  const shown = other ?? best;
  return all.map((viewer) => ({
    title: viewer.title,
    viewer: viewer === best ? '' : viewer.id,
    isShown: viewer === shown,
  }));
}

/** Returns a viewer by its id; `undefined` for one that this version does not have. */
export function viewerById(id: string): TopicViewer | undefined {
  return VIEWERS.find((viewer) => viewer.id === id);
}
