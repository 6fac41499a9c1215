import type { Recording } from '@ubii/proto';
import type { Component } from 'vue';
import type { ReadableFile } from '../files/readable-file.ts';
import type { OpenedPlayer } from './opened-player.ts';
import type { Span } from '../timeline/span.ts';

/** A span of an opened recording: what an action gets. */
export interface SpanTarget {
  readonly span: Span;
  readonly opened: OpenedPlayer;
  /** At the master; undefined for a file of this device. */
  readonly recording: Recording | undefined;
  /** The file or its address, for a worker of the action's own. */
  readonly source: ReadableFile;
}

/** What can be done with a span of a recording. */
export interface SpanAction {
  /** Verb and object. */
  readonly text: string;
  readonly icon: Component;
  /** Returns why the action is not available, shown as its text; undefined when it is. */
  refusal?(target: SpanTarget): string | undefined;
  /** Dialog with the property `target: SpanTarget` and the event `close`; loaded on first use (`loadLater`). */
  readonly dialog: Component;
}
