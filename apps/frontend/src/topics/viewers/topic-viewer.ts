import type { DataFormat, JsonValue, TopicRecord } from '@ubii/proto';
import type { Component } from 'vue';
import type { TopicHistory } from '../history/topic-history.ts';

/** Where the time that is shown ends. */
export interface ViewEnd {
  /** This machine's clock; `undefined` for now, which moves. */
  readonly ms: number | undefined;
  /** What stands there: `now`, `paused`, `lost`, `end`. */
  readonly text: string;
}

/** What a person set in a viewer, as it is kept with a layout. A viewer reads it as from a stranger. */
export type ViewerSettings = Readonly<Record<string, JsonValue>>;

/**
 * What every viewer is given. It fills the place it is given (`height: 100%`, at least 180 px high) and
 * may be small; what it sets is told with the event `update:settings`, whole. With the event `pick` (a moment, this
 * machine's clock) it asks for the record there.
 */
export interface ViewerProps {
  readonly topic: string;
  /** The newest record, or the one a paused view stands still at. */
  readonly record: TopicRecord;
  /** What has come on the topic since it is looked at. */
  readonly history: TopicHistory;
  readonly end: ViewEnd;
  readonly settings: ViewerSettings;
}

/** A way to look at the values of a topic. */
export interface TopicViewer {
  /** Kept in layouts and links: never changes. */
  readonly id: string;
  /** One or two words. */
  readonly title: string;
  fits(format: DataFormat): boolean;
  /** Offered after the others that fit. @default false */
  isSecond?(format: DataFormat): boolean;
  /** False for what the page of a topic shows beside the value anyway. @default true */
  readonly isInDetail?: boolean;
  /** Takes `ViewerProps`; large ones are loaded when they are first shown. */
  readonly component: Component;
}
