import type { DataFormat, JsonValue, TopicRecord } from '@ubii/proto';
import type { Component } from 'vue';
import type { TopicHistory } from '../history/topic-history.ts';

/** End of the visible time. */
export interface ViewEnd {
  /** This computer's clock; `undefined` for now. */
  readonly ms: number | undefined;
  /** Label: `now`, `paused`, `lost`, `end`. */
  readonly text: string;
}

/** Settings of a viewer, stored with a layout. Viewers must validate them, because links can contain anything. */
export type ViewerSettings = Readonly<Record<string, JsonValue>>;

/**
 * Properties of every viewer. It fills its box (`height: 100%`, at least 180 px high), which may be small; it emits
 * `update:settings` with all its settings, and `pick` with a time of this computer's clock to show the record at that
 * time.
 */
export interface ViewerProps {
  readonly topic: string;
  /** The newest record, or the one at which a paused view stopped. */
  readonly record: TopicRecord;
  /** Records of the topic since it was opened. */
  readonly history: TopicHistory;
  readonly end: ViewEnd;
  readonly settings: ViewerSettings;
}

/** What a view that publishes on its topic has beside the rest. It is shown also before the first value. */
export interface ControlSpec {
  /** Data formats that it sends, the default for a new topic first. */
  readonly formats: readonly DataFormat[];
  /** Form for its settings, in a dialog; a component with `ControlOptionsProps`. */
  readonly options?: { readonly title: string; readonly component: Component };
  /** True when it needs little height. */
  readonly isLow: boolean;
}

/** Properties of the form for the settings of a control, which emits `update:settings` with all of them. */
export interface ControlOptionsProps {
  readonly settings: ViewerSettings;
  readonly format: DataFormat;
}

/** Display of a topic's values. */
export interface TopicViewer {
  /** Stored in layouts and links: must never change. */
  readonly id: string;
  /** One or two words. */
  readonly title: string;
  fits(format: DataFormat): boolean;
  /** Offered after the other viewers that fit. @default false */
  isSecond?(format: DataFormat): boolean;
  /** False for contents that the topic's page shows beside the viewer anyway. @default true */
  readonly isInDetail?: boolean;
  /** For views that publish on their topic. */
  readonly control?: ControlSpec;
  /** Component with `ViewerProps`; large ones are loaded on first use. */
  readonly component: Component;
}
