import type { EXAMPLE_SESSIONS } from '@ubii/modules';
import type { InputName } from './inputs/input-names.ts';

/** A line of a plot. */
export interface PreviewLine {
  /** Last part of the topic. */
  readonly topic: string;
  /** Letter at the end of the line. */
  readonly letter: string;
  readonly stroke: 'solid' | 'light' | 'dashed';
}

/** The drawing of a preview. Each topic is the part after `/examples/<id>/`. */
export type PreviewView =
  | {
      readonly kind: 'lines';
      readonly lines: readonly PreviewLine[];
      /** Minimum and maximum of the value axis. */
      readonly range: readonly [number, number];
      /** Topics of events, drawn as marks at their time of arrival. */
      readonly events?: readonly string[];
      /** Values drawn as dashed lines. */
      readonly levels?: readonly number[];
      /** A number in large digits. */
      readonly readout?: { readonly topic: string; readonly unit: string };
      /** Topic of a position drawn over the plot. */
      readonly pointer?: string;
    }
  | {
      readonly kind: 'surface';
      /** Positions drawn as trails. */
      readonly trails: readonly { readonly topic: string; readonly stroke: 'solid' | 'light' }[];
      /** Positions, each drawn as a ring with a line to `middle`. */
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
  /** Describes the session in one sentence. */
  readonly sentence: string;
  /** What to do in its graph, and what is seen then. */
  readonly advice: string;
  /** Concepts that the session demonstrates. */
  readonly shows: readonly string[];
  /** Inputs from this page, each with the topic of the session that it replaces. */
  readonly inputs: readonly { readonly topic: string; readonly input: InputName }[];
  readonly view: PreviewView;
}

const entry = (
  id: GalleryEntry['id'],
  title: string,
  sentence: string,
  advice: string,
  shows: readonly string[],
  view: PreviewView,
  inputs: Readonly<Record<string, InputName>> = {},
): GalleryEntry => ({
  id,
  title,
  sentence,
  advice,
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

/** Twelve sessions, ordered from simple to complex. */
export const GALLERY: readonly GalleryEntry[] = [
  entry(
    'sine-wave',
    'Sine wave',
    'One module generates a sine wave with 60 values per second.',
    'Change waveHz of “clock” and watch “wave” change its pace.',
    ['Frequency mode', 'Source'],
    { kind: 'lines', lines: [solid('wave', 's')], range: [-1.2, 1.2] },
  ),
  entry(
    'mixed-waves',
    'Two waves, mixed',
    'Two modules generate a slow and a fast wave, and a third one adds them.',
    'Change waveHz of one “clock” and watch “mixed” follow.',
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
    'Measures the speed of your pointer, in windows per second.',
    'Move your pointer over this page, and watch “speed” rise.',
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
    'A 1€ filter removes the jitter of a pointer.',
    'Move your pointer over this page: “smoothed” follows it without the jitter.',
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
    'Converts the pointer position to a colour: hue from x, lightness from y.',
    'Move your pointer over this page, and watch “color” change.',
    ['Trigger mode', 'Vector to colour'],
    { kind: 'color', color: 'color', hex: 'hex', pointer: 'pointer' },
    { pointer: 'pointer' },
  ),
  entry(
    'click-counter',
    'Click counter',
    'Counts the clicks on this page. Escape sets the count to 0.',
    'Click an empty spot of the canvas, and watch “count” rise.',
    ['Events', 'State', 'Reset'],
    { kind: 'count', count: 'count', pressed: 'pressed' },
    { pressed: 'pressed', reset: 'escape' },
  ),
  entry(
    'metronome',
    'Metronome and drift',
    'Ticks twice a second, and measures the drift between a frequency module and a lockstep module.',
    'Watch “beats” count, and “drift_ms” move around 0.',
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
    'Mean of many pointers',
    'Computes the mean of the pointers of all pages and phones, and of two animated pointers.',
    'Move your pointer, or connect a phone: “middle” follows.',
    ['Muxer', 'Demuxer'],
    {
      kind: 'surface',
      trails: [],
      points: ['loop/position', 'wave/position', 'guest/position'],
      middle: 'middle',
    },
    { 'guest/position': 'pointer' },
  ),
  entry(
    'hysteresis',
    'Threshold with hysteresis',
    'Converts a noisy wave to one event for each crossing of the threshold.',
    'Watch “rise_count”: it rises once for each crossing, although “noisy” jitters.',
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
    'Computes the mean of a noisy number over the last second.',
    'Compare “noisy” with “mean”, which is smoother and a little later.',
    ['Noise', 'Time window'],
    {
      kind: 'lines',
      lines: [light('noisy', 'n'), solid('mean', 'm')],
      range: [-1.6, 1.6],
    },
  ),
  entry(
    'picture-edges',
    'Edges of a picture',
    'Generates a picture, converts it to greyscale, and detects its edges.',
    'Watch the two pictures: “edges” has the outlines of what moves in “picture”.',
    ['Pictures', 'Chain of two modules'],
    { kind: 'pictures', topics: ['picture', 'edges'] },
  ),
  entry(
    'key-chord',
    'Keys to text',
    'Joins the keys that you hold on this page into one text.',
    'Hold some letter keys on this page, and watch “chord”.',
    ['Key events', 'Text'],
    { kind: 'text', text: 'chord', empty: 'No key is held' },
    { key: 'key' },
  ),
];
