import { DATA_FORMATS, type DataFormat } from '@ubii/proto';
import { seriesOf } from '../values/value-series.ts';
import JsonViewer from './JsonViewer.vue';
import PictureViewer from './PictureViewer.vue';
import PlotViewer from './PlotViewer.vue';
import type { TopicViewer } from './topic-viewer.ts';

/** Every viewer, in the order in which they are offered: the first that fits a format is the best. */
export const VIEWERS: readonly TopicViewer[] = [
  {
    id: 'picture',
    title: 'Picture',
    fits: (format) => DATA_FORMATS[format].family === 'image',
    component: PictureViewer,
  },
  {
    id: 'plot',
    title: 'Plot',
    fits: (format) => seriesOf(format) !== undefined,
    component: PlotViewer,
  },
  { id: 'json', title: 'JSON', fits: () => true, component: JsonViewer },
];

/** The viewers that fit a data format, the best one first; at least one. */
export function viewersOf(format: DataFormat): readonly TopicViewer[] {
  return VIEWERS.filter((viewer) => viewer.fits(format));
}

/** The viewer that fits a data format best. */
export function viewerOf(format: DataFormat): TopicViewer {
  return viewersOf(format)[0]!;
}

/** A viewer by its id; `undefined` for one that this version does not have. */
export function viewerById(id: string): TopicViewer | undefined {
  return VIEWERS.find((viewer) => viewer.id === id);
}
