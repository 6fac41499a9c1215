import { inject, shallowRef, type InjectionKey, type ShallowRef } from 'vue';
import type { Command } from './command.ts';

/** What floats over the page; one at a time. */
export type ShellDialog = 'palette' | 'connect-phone' | 'shortcuts' | 'identity' | 'more';

/** How pages reach the dialogs of the shell. */
export interface Shell {
  readonly dialog: ShallowRef<ShellDialog | undefined>;
  /** What the page is about, when that has a name; `usePageTitle` sets it. */
  readonly pageTitle: ShallowRef<string | undefined>;
  /** What can be done on the page, for the palette; `usePageCommands` sets it. */
  readonly pageCommands: ShallowRef<readonly Command[]>;
  open(dialog: ShellDialog): void;
  close(): void;
}

/** Where a page may put a title of its own making into the top bar, with a Teleport. */
export const PAGE_TITLE_ID = 'page-title';

export const SHELL: InjectionKey<Shell> = Symbol('shell');

export function createShell(): Shell {
  const dialog = shallowRef<ShellDialog>();
  return {
    dialog,
    pageTitle: shallowRef<string>(),
    pageCommands: shallowRef<readonly Command[]>([]),
    open: (next) => (dialog.value = next),
    close: () => (dialog.value = undefined),
  };
}

export function useShell(): Shell {
  const shell = inject(SHELL);
  if (!shell) throw new Error('useShell() needs AppShell above it.');
  return shell;
}
