import {
  AudioWaveform,
  Braces,
  Camera,
  Cpu,
  FlipHorizontal2,
  Gauge,
  Globe,
  Merge,
  Radar,
  ScanSearch,
  Sigma,
  Spline,
  Timer,
  ArrowRightLeft,
  ToggleRight,
} from '@lucide/vue';
import type { ProcessingModule } from '@ubii/proto';
import type { Component } from 'vue';

/** Words in the name or the tags of a module, and the picture for it; the first that is found counts. */
const ICONS: readonly (readonly [RegExp, Component])[] = [
  [/proximity|near/, Radar],
  [/detect|recogni|track/, ScanSearch],
  [/camera|image|picture/, Camera],
  [/mirror|flip/, FlipHorizontal2],
  [/threshold|gate|switch/, ToggleRight],
  [/smooth|filter|low-pass|euro/, Spline],
  [/statistic|mean|sum/, Sigma],
  [/map|range|scale|convert/, ArrowRightLeft],
  [/pick|field|select/, Braces],
  [/merge|gather|combine/, Merge],
  [/clock|timer/, Timer],
  [/load|benchmark/, Gauge],
  [/http|poll|web/, Globe],
  [/wave|generator|audio/, AudioWaveform],
];

/** A picture for what a module does, so that nodes are distinguished from afar. */
export function moduleIcon({ name, tags }: Pick<ProcessingModule, 'name' | 'tags'>): Component {
  const find = (text: string): Component | undefined =>
    ICONS.find(([words]) => words.test(text.toLowerCase()))?.[1];
  return find(name) ?? find(tags.join(' ')) ?? Cpu;
}
