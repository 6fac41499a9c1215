import { inject, shallowRef, type InjectionKey, type ShallowRef } from 'vue';

/** What floats over the page; one at a time. */
export type ShellDialog = 'palette' | 'connect-phone' | 'shortcuts' | 'identity';

/** How pages reach the dialogs of the shell. */
export interface Shell {
  readonly dialog: ShallowRef<ShellDialog | undefined>;
  /** What the page is about, when that has a name; `usePageTitle` sets it. */
  readonly pageTitle: ShallowRef<string | undefined>;
  open(dialog: ShellDialog): void;
  close(): void;
}

export const SHELL: InjectionKey<Shell> = Symbol('shell');

export function createShell(): Shell {
  const dialog = shallowRef<ShellDialog>();
  return {
    dialog,
    pageTitle: shallowRef<string>(),
    open: (next) => (dialog.value = next),
    close: () => (dialog.value = undefined),
  };
}

export function useShell(): Shell {
  const shell = inject(SHELL);
  if (!shell) throw new Error('useShell() needs AppShell above it.');
  return shell;
}
