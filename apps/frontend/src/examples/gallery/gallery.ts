import type { EXAMPLE_SESSIONS } from '@ubii/modules';
import type { InputName } from './inputs/input-names.ts';

/** A line of a plot. */
export interface PreviewLine {
  /** Last part of the topic. */
  readonly topic: string;
  /** Letter at its end. */
  readonly letter: string;
  readonly stroke: 'solid' | 'light' | 'dashed';
}

/** What the preview of an example draws. Topics are the last part, below `/examples/<id>/`. */
export type PreviewView =
  | {
      readonly kind: 'lines';
      readonly lines: readonly PreviewLine[];
      /** Lower and upper end of the value axis. */
      readonly range: readonly [number, number];
      /** Events, as marks at the time when they came. */
      readonly events?: readonly string[];
      /** Values that are drawn as dashed levels. */
      readonly levels?: readonly number[];
      /** A number that is shown large. */
      readonly readout?: { readonly topic: string; readonly unit: string };
      /** A position that is shown over the plot. */
      readonly pointer?: string;
    }
  | {
      readonly kind: 'surface';
      /** Drawn as a trail, unsmoothed: thin; smoothed: thick. */
      readonly trails: readonly { readonly topic: string; readonly stroke: 'solid' | 'light' }[];
      /** Positions, each as a ring with a line to the middle. */
      readonly points?: readonly string[];
      readonly middle?: string;
    }
  | {
      readonly kind: 'color';
      readonly color: string;
      readonly hex: string;
      readonly pointer: string;
    }
  | { readonly kind: 'count'; readonly count: string; readonly pressed: string }
  | { readonly kind: 'pictures'; readonly topics: readonly string[] }
  | { readonly kind: 'text'; readonly text: string; readonly empty: string };

/** An example session of the gallery. */
export interface GalleryEntry {
  readonly id: keyof typeof EXAMPLE_SESSIONS;
  readonly title: string;
  /** What it does, one sentence. */
  readonly sentence: string;
  /** What can be learned from it, a few words each. */
  readonly shows: readonly string[];
  /** What it takes from this page, by the topic that stands for it in the session. */
  readonly inputs: readonly { readonly topic: string; readonly input: InputName }[];
  readonly view: PreviewView;
}

const entry = (
  id: GalleryEntry['id'],
  title: string,
  sentence: string,
  shows: readonly string[],
  view: PreviewView,
  inputs: Readonly<Record<string, InputName>> = {},
): GalleryEntry => ({
  id,
  title,
  sentence,
  shows,
  view,
  inputs: Object.entries(inputs).map(([topic, input]) => ({
    topic: `/examples/${id}/${topic}`,
    input,
  })),
});

const solid = (topic: string, letter: string): PreviewLine => ({ topic, letter, stroke: 'solid' });
const light = (topic: string, letter: string): PreviewLine => ({ topic, letter, stroke: 'light' });
const dashed = (topic: string, letter: string): PreviewLine => ({
  topic,
  letter,
  stroke: 'dashed',
});

/** Twelve sessions, simple ones first. */
export const GALLERY: readonly GalleryEntry[] = [
  entry(
    'sine-wave',
    'Sine wave',
    'One module makes a wave, 60 times a second.',
    ['Frequency mode', 'Source'],
    { kind: 'lines', lines: [solid('wave', 's')], range: [-1.2, 1.2] },
  ),
  entry(
    'mixed-waves',
    'Two waves, mixed',
    'A slow wave and a fast one, and a mixer that adds them.',
    ['Two instances of a module', 'Constants'],
    {
      kind: 'lines',
      lines: [light('slow', 'a'), dashed('fast', 'b'), solid('mixed', 'm')],
      range: [-1.6, 1.6],
    },
  ),
  entry(
    'pointer-speed',
    'Pointer speed',
    'The speed of your pointer, in windows a second.',
    ['Frequency mode', 'Vector to number'],
    {
      kind: 'lines',
      lines: [solid('speed', 'v')],
      range: [0, 2.5],
      readout: { topic: 'speed', unit: '/s' },
      pointer: 'pointer',
    },
    { pointer: 'pointer' },
  ),
  entry(
    'smooth-pointer',
    'Smooth a pointer',
    'A shaky pointer goes in, a calm one comes out: the 1€ filter.',
    ['Trigger mode', 'Filter'],
    {
      kind: 'surface',
      trails: [
        { topic: 'pointer', stroke: 'light' },
        { topic: 'smoothed', stroke: 'solid' },
      ],
    },
    { pointer: 'pointer' },
  ),
  entry(
    'pointer-color',
    'Pointer to colour',
    'Left to right is the hue, top to bottom the lightness.',
    ['Trigger mode', 'Vector to colour'],
    { kind: 'color', color: 'color', hex: 'hex', pointer: 'pointer' },
    { pointer: 'pointer' },
  ),
  entry(
    'click-counter',
    'Click counter',
    'Every click on this page counts. Escape sets the counter to zero.',
    ['Events', 'State', 'Reset'],
    { kind: 'count', count: 'count', pressed: 'pressed' },
    { pressed: 'pressed', reset: 'escape' },
  ),
  entry(
    'metronome',
    'Metronome and drift',
    'Two beats a second, and how far a module with a timer of its own drifts from one in lockstep.',
    ['Frequency mode', 'Lockstep mode'],
    {
      kind: 'lines',
      lines: [solid('drift_ms', 'd')],
      range: [-120, 120],
      events: ['tick'],
      levels: [0],
      readout: { topic: 'beats', unit: 'beats' },
    },
  ),
  entry(
    'many-pointers',
    'Many pointers, one middle',
    'The pointers of all pages and phones, with two that move by themselves, and their middle.',
    ['Muxer', 'Demuxer'],
    {
      kind: 'surface',
      trails: [],
      points: ['circle/position', 'wave/position', 'guest/position'],
      middle: 'middle',
    },
    { 'guest/position': 'pointer' },
  ),
  entry(
    'hysteresis',
    'Threshold with hysteresis',
    'A noisy wave becomes one event for each crossing, and not many.',
    ['Number to events', 'Hysteresis'],
    {
      kind: 'lines',
      lines: [solid('noisy', 'n')],
      range: [-1.6, 1.6],
      events: ['rose', 'fell'],
      levels: [0.2, -0.2],
      readout: { topic: 'rise_count', unit: 'rises' },
    },
  ),
  entry(
    'moving-average',
    'Moving average',
    'A noisy number and its mean over the last second.',
    ['Noise', 'Window of time'],
    {
      kind: 'lines',
      lines: [light('noisy', 'n'), solid('mean', 'm')],
      range: [-1.6, 1.6],
    },
  ),
  entry(
    'picture-edges',
    'Edges of a picture',
    'A generated picture, the same in grey, and its edges.',
    ['Images', 'Two modules in a row'],
    { kind: 'pictures', topics: ['picture', 'edges'] },
  ),
  entry(
    'key-chord',
    'Keys to text',
    'Hold two or three keys on this page: they become one text.',
    ['Key events', 'Text'],
    { kind: 'text', text: 'chord', empty: 'No key is held' },
    { key: 'key' },
  ),
];
