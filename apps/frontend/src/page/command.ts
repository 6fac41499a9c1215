import type { Component } from 'vue';

export type CommandKind =
  | 'page'
  | 'example'
  | 'session'
  | 'module'
  | 'client'
  | 'service'
  | 'topic'
  | 'publish'
  | 'action';

/** Entry of the command palette. */
export interface Command {
  /** Stable, so that it can be stored as recently used. */
  readonly id: string;
  readonly kind: CommandKind;
  readonly title: string;
  /** Dimmed text after the title; searched, too. */
  readonly detail?: string;
  readonly shortcut?: string;
  /** Symbol on the left: an icon, the socket of a data format, or the mark of a client. */
  readonly icon?: Component;
  readonly format?: string;
  readonly clientId?: string;
  readonly run: () => void;
}
