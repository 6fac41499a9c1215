import type { Component } from 'vue';
import type { Command } from '../../../page/command.ts';
import type { MenuItem } from '../../../ui/UiMenu.vue';

/** Something people do with the session as a whole; the same in the menu and in the palette. */
export interface SessionCommand {
  readonly id: string;
  readonly text: string;
  /** In the palette, where nothing else says what it is about. @default `text` */
  readonly title?: string;
  readonly icon: Component;
  readonly shortcut?: string;
  readonly danger?: boolean;
  /** Begins a part of the menu. */
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
