import { capitalised } from '@ubii/words';

import {
  isAlive,
  sessionState,
  stateLook,
  type LifeAction,
} from '../../sessions/state/session-state.ts';
import { useToastsOf } from '../../ui/toasts/toasts.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';
import type { Saving } from './useSave.ts';

/** Starts, pauses and stops the session; used by the run bar, the session menu and keys. */
export interface Life {
  can(action: LifeAction): boolean;
  /** Saves unsaved changes first, and shows a message. */
  act(action: LifeAction): Promise<void>;
  /** Saves, and shows a message. */
  save(): Promise<void>;
}

export function useLife(editor: GraphEditor, saving: Saving): Life {
  const { show } = useToastsOf('life of a session');
  /**
   * A session without persistence was applied, not stored: it ends with the master, or with the page that created it.
   */
  function tell(done: string): void {
    const isStored = editor.session.value.extension?.stored === true;
    show(isStored ? `Saved and ${done}` : capitalised(done));
  }
  return {
    can: (action) => stateLook(sessionState(editor.session.value)).actions.includes(action),
    async act(action) {
      const isUnsaved = editor.changes.value > 0;
      await saving.act(action);
      if (!isUnsaved || editor.changes.value > 0 || saving.failure.value !== undefined) return;
      tell(DONE[action]);
    },
    async save() {
      const isUnsaved = editor.changes.value > 0;
      if (!(await saving.save()) || !isUnsaved) return;
      if (isAlive(editor.session.value)) tell('applied');
      else show('Saved');
    },
  };
}

const DONE: Readonly<Record<LifeAction, string>> = {
  start: 'started',
  resume: 'resumed',
  restart: 'restarted',
  pause: 'paused',
  stop: 'stopped',
};
