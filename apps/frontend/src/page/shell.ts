import { shallowRef, type InjectionKey, type ShallowRef } from 'vue';
import { injectOrThrow } from '../context/inject-or-throw.ts';
import type { Command } from './command.ts';

/** Dialogs of the shell; one at a time. */
export type ShellDialog = 'palette' | 'connect-phone' | 'shortcuts' | 'identity' | 'more';

/** Interface of the shell for pages. */
export interface Shell {
  readonly dialog: ShallowRef<ShellDialog | undefined>;
  /** Name of what the page shows; set by `usePageTitle`. */
  readonly pageTitle: ShallowRef<string | undefined>;
  /** Name that the page has as its heading; set by `PageFrame`. */
  readonly pageHeading: ShallowRef<string | undefined>;
  /** Commands of the page, for the palette; set by `usePageCommands`. */
  readonly pageCommands: ShallowRef<readonly Command[]>;
  open(dialog: ShellDialog): void;
  close(): void;
}

/** Id of the element in the top bar into which a page can teleport its own title. */
export const PAGE_TITLE_ID = 'page-title';

export const SHELL: InjectionKey<Shell> = Symbol('shell');

export function createShell(): Shell {
  const dialog = shallowRef<ShellDialog>();
  return {
    dialog,
    pageTitle: shallowRef<string>(),
    pageHeading: shallowRef<string>(),
    pageCommands: shallowRef<readonly Command[]>([]),
    open: (next) => (dialog.value = next),
    close: () => (dialog.value = undefined),
  };
}

export function useShell(): Shell {
  return injectOrThrow(SHELL, 'AppShell above it');
}
