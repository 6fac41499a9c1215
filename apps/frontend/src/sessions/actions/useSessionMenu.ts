import {
  Copy,
  Download,
  FileBraces,
  Pencil,
  RotateCw,
  Square,
  Trash2,
  Workflow,
} from '@lucide/vue';
import type { Session } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import { useRouter } from 'vue-router';
import { saveFile } from '../../files/save-file.ts';
import { sessionLocation, sessionTextLocation } from '../../locations/session-location.ts';
import type { MenuItem } from '../../ui/UiMenu.vue';
import { exportSession } from '../file/session-file.ts';
import { sessionState, stateLook } from '../state/session-state.ts';
import { sessionSpec } from '../text/session-spec.ts';
import type { SessionActions } from './useSessionActions.ts';

/** Menu of a session with the less frequent actions. */
export interface SessionMenu {
  itemsFor(session: Session): readonly MenuItem[];
  /** Opens the dialog for renaming. */
  rename(session: Session): void;
  /** Session being renamed, for the dialog. */
  readonly renaming: ShallowRef<Session | undefined>;
}

export function useSessionMenu(actions: SessionActions, removed: () => void): SessionMenu {
  const router = useRouter();
  const renaming = shallowRef<Session>();

  async function duplicate(session: Session): Promise<void> {
    const copy = await actions.duplicate(session);
    if (copy) await router.push(sessionLocation(copy.id));
  }
  const rename = (session: Session): void => {
    renaming.value = session;
  };
  async function remove(session: Session): Promise<void> {
    await actions.remove(session);
    if (!actions.failures.value.has(session.id)) removed();
  }

  function itemsFor(session: Session): readonly MenuItem[] {
    const can = stateLook(sessionState(session)).actions;
    const life: MenuItem[] = [];
    if (can.includes('stop')) {
      life.push({ text: 'Stop', icon: Square, run: () => void actions.act(session, 'stop') });
    }
    if (can.includes('restart')) {
      life.push({
        text: 'Restart',
        icon: RotateCw,
        run: () => void actions.act(session, 'restart'),
      });
    }
    if (life.length > 0) life.push({ kind: 'separator' });
    return [
      ...life,
      {
        text: 'Open',
        icon: Workflow,
        run: () => void router.push(sessionLocation(session.id)),
      },
      { text: 'Rename', icon: Pencil, shortcut: 'F2', run: () => rename(session) },
      { text: 'Duplicate', icon: Copy, run: () => void duplicate(session) },
      {
        text: 'Edit as JSON',
        icon: FileBraces,
        run: () => void router.push(sessionTextLocation(session.id)),
      },
      {
        text: 'Export',
        icon: Download,
        run: () => saveFile(exportSession(sessionSpec(session))),
      },
      { kind: 'separator' },
      {
        text: 'Delete',
        icon: Trash2,
        shortcut: 'Del',
        danger: true,
        run: () => void remove(session),
      },
    ];
  }

  return { itemsFor, rename, renaming };
}
