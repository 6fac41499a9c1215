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

/** Icons by words in the name or tags of a module; the first match counts. */
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

/** Icon for the purpose of a module, so that nodes are distinguishable at a far zoom. */
export function moduleIcon({ name, tags }: Pick<ProcessingModule, 'name' | 'tags'>): Component {
  const find = (text: string): Component | undefined =>
    ICONS.find(([words]) => words.test(text.toLowerCase()))?.[1];
  return find(name) ?? find(tags.join(' ')) ?? Cpu;
}
