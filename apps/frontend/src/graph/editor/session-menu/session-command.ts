import type { Component } from 'vue';
import type { Command } from '../../../page/command.ts';
import type { MenuItem } from '../../../ui/UiMenu.vue';

/** Command on the whole session, for the session menu and the command palette. */
export interface SessionCommand {
  readonly id: string;
  readonly text: string;
  /** Label in the command palette, which lacks the context of the menu. @default `text` */
  readonly title?: string;
  readonly icon: Component;
  readonly shortcut?: string;
  readonly danger?: boolean;
  /** Starts a new group in the menu. */
  readonly isFirst?: boolean;
  readonly isDisabled?: boolean;
  readonly run: () => void;
}

export function menuItems(commands: readonly SessionCommand[]): MenuItem[] {
  return commands.flatMap(({ text, icon, shortcut, danger, isFirst, isDisabled, run }, index) => {
    const item: MenuItem = {
      text,
      icon,
      disabled: isDisabled ?? false,
      run,
      ...(shortcut !== undefined && { shortcut }),
      ...(danger !== undefined && { danger }),
    };
    return isFirst === true && index > 0 ? [{ kind: 'separator' } as const, item] : [item];
  });
}

export function paletteCommands(commands: readonly SessionCommand[]): Command[] {
  return commands
    .filter(({ isDisabled }) => isDisabled !== true)
    .map(({ id, text, title = text, icon, shortcut, run }) => ({
      id: `graph ${id}`,
      kind: 'action',
      title,
      icon,
      run,
      ...(shortcut !== undefined && { shortcut }),
    }));
}
