import type { Component } from 'vue';

export type CommandKind =
  'page' | 'example' | 'session' | 'module' | 'client' | 'service' | 'topic' | 'action';

/** Something the palette finds. */
export interface Command {
  /** Stable, so that it is remembered as recent. */
  readonly id: string;
  readonly kind: CommandKind;
  readonly title: string;
  /** Dimmer, behind the title; searched too. */
  readonly detail?: string;
  readonly shortcut?: string;
  /** What stands at the left: an icon, a data format's socket, or a letter. */
  readonly icon?: Component;
  readonly format?: string;
  readonly letter?: string;
  readonly run: () => void;
}
