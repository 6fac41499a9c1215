import {
  Copy,
  Download,
  FileBraces,
  FilePlus,
  FolderOpen,
  Import,
  Info,
  LayoutDashboard,
  Pencil,
  Play,
  RotateCw,
  Save,
  SaveAll,
  Square,
  Trash2,
} from '@lucide/vue';
import type { Init, Session } from '@ubii/proto';
import { computed, ref, type ComputedRef, type Ref } from 'vue';
import { useRouter } from 'vue-router';
import { randomUuid } from '../../../connection/random-uuid.ts';
import { useConnection } from '../../../connection/useConnection.ts';
import type { SessionActions } from '../../../sessions/actions/useSessionActions.ts';
import { completeSession } from '../../model/complete-session.ts';
import { knownModules } from '../../../sessions/file/known-modules.ts';
import { saveFile } from '../../../files/save-file.ts';
import { exportSession } from '../../../sessions/file/session-file.ts';
import { sessionLocation, sessionTextLocation } from '../../../locations/session-location.ts';
import { sessionPanelsLocation } from '../../../locations/topic-location.ts';
import { sessionPanels } from '../../../sessions/text/session-panels.ts';
import { copyName, sessionCopy, sessionSpec } from '../../../sessions/text/session-spec.ts';
import type { GraphEditor } from '../../editing/graph-editor.ts';
import { findDraft, saveDraft } from '../../model/changes/draft.ts';
import type { Drafts } from '../useDraft.ts';
import { useLife } from '../useLife.ts';
import type { Saving } from '../useSave.ts';
import { chooseFiles } from './choose-files.ts';
import type { SessionCommand } from './session-command.ts';

/** Open dialog of the session menu. */
export type SessionQuestion = 'open' | 'saveAs' | 'rename' | 'details';

export interface SessionCommands {
  readonly list: ComputedRef<readonly SessionCommand[]>;
  readonly question: Ref<SessionQuestion | undefined>;
  /** Names of other sessions. */
  readonly taken: ComputedRef<ReadonlySet<string>>;
  readonly copyName: ComputedRef<string>;
  saveAs(name: string): Promise<void>;
  open(session: Session): Promise<void>;
}

interface Parts {
  readonly editor: GraphEditor;
  readonly saving: Saving;
  readonly drafts: Drafts;
  readonly actions: SessionActions;
  /** Whether the session is missing on the master. */
  readonly isGone: () => boolean;
  readonly importFiles: (files: readonly File[]) => void;
}

/** Commands on the session as a whole. */
export function useSessionCommands(parts: Parts): SessionCommands {
  const { editor, saving, drafts, actions, isGone, importFiles } = parts;
  const { client, sessions } = useConnection();
  const router = useRouter();
  const question = ref<SessionQuestion>();
  const life = useLife(editor, saving);
  const startAction = computed(() => (life.can('resume') ? 'resume' : 'start'));
  const name = computed(() => editor.graph.value.details.name || 'Session');
  const taken = computed(() => {
    const others = (sessions.list.value ?? []).filter(({ id }) => id !== editor.session.value.id);
    return new Set(others.map((other) => other.name));
  });
  const copy = computed(() => copyName(name.value, new Set([...taken.value, name.value])));

  /** Creates a session and shows it. @returns undefined when the master refused it; the reason is shown */
  async function make(spec: Init<Session>): Promise<Session | undefined> {
    const made = await saving.request(() => actions.calls.create(spec));
    if (made) await router.push(sessionLocation(made.id));
    return made;
  }
  const ownCopy = (as: string): Init<Session> => ({
    ...sessionCopy(sessionSpec(editor.toSession()), randomUuid),
    name: as,
  });

  async function saveAs(as: string): Promise<void> {
    const { id } = editor.session.value;
    const made = await make(ownCopy(as));
    // The copy has the changes: discard the draft of the original.
    if (made) drafts.forget(id);
  }

  async function exportFile(): Promise<void> {
    const library = (await knownModules(client)) ?? [];
    saveFile(exportSession(sessionSpec(completeSession(editor.toSession(), library))));
  }

  async function remove(): Promise<void> {
    const session = editor.session.value;
    drafts.keep();
    drafts.pause();
    const draft = findDraft(localStorage, session.id);
    if (isGone()) {
      drafts.forget(session.id);
      await router.push('/sessions');
      return;
    }
    const isRemoved = await actions.remove(session, (restored) => {
      if (draft !== undefined) saveDraft(localStorage, draft);
      void router.push(sessionLocation(restored.id));
    });
    if (!isRemoved) {
      drafts.resume();
      return;
    }
    drafts.forget(session.id);
    await router.push('/sessions');
  }

  const id = (): string => editor.session.value.id;
  const list = computed((): readonly SessionCommand[] => [
    {
      id: 'new',
      text: 'New',
      title: 'New empty session',
      icon: FilePlus,
      run: () => void router.push('/sessions/new'),
    },
    {
      id: 'open',
      text: 'Open…',
      title: 'Open another session',
      icon: FolderOpen,
      shortcut: 'Ctrl O',
      run: () => (question.value = 'open'),
    },
    {
      id: 'save',
      text: 'Save',
      title: 'Save this session',
      icon: Save,
      shortcut: 'Ctrl S',
      isFirst: true,
      isDisabled: editor.changes.value === 0,
      run: () => void life.save(),
    },
    {
      id: 'start',
      text: startAction.value === 'resume' ? 'Resume' : 'Start',
      title: 'Save and start this session',
      icon: Play,
      shortcut: 'Ctrl Enter',
      isDisabled: !life.can(startAction.value) && editor.changes.value === 0,
      // While the session runs, apply its changes.
      run: () => void (life.can(startAction.value) ? life.act(startAction.value) : life.save()),
    },
    {
      id: 'stop',
      text: 'Stop',
      title: 'Stop this session',
      icon: Square,
      shortcut: 'Ctrl Shift Enter',
      isDisabled: !life.can('stop'),
      run: () => void life.act('stop'),
    },
    {
      id: 'restart',
      text: 'Restart',
      title: 'Restart this session',
      icon: RotateCw,
      isDisabled: !life.can('restart'),
      run: () => void life.act('restart'),
    },
    {
      id: 'save-as',
      text: 'Save as…',
      title: 'Save this session as another one',
      icon: SaveAll,
      shortcut: 'Ctrl Shift S',
      run: () => (question.value = 'saveAs'),
    },
    {
      id: 'rename',
      text: 'Rename',
      title: 'Rename this session',
      icon: Pencil,
      shortcut: 'F2',
      run: () => (question.value = 'rename'),
    },
    {
      id: 'details',
      text: 'Details…',
      title: 'Description and restart of this session',
      icon: Info,
      run: () => (question.value = 'details'),
    },
    {
      id: 'duplicate',
      text: 'Duplicate',
      title: 'Duplicate this session',
      icon: Copy,
      run: () => void make(ownCopy(copy.value)),
    },
    ...(sessionPanels(editor.session.value) === undefined
      ? []
      : [
          {
            id: 'panels',
            text: 'Open panels',
            title: 'Open the panels of this session',
            icon: LayoutDashboard,
            run: () => void router.push(sessionPanelsLocation(id())),
          },
        ]),
    {
      id: 'text',
      text: 'Edit as JSON',
      title: 'Edit this session as JSON',
      icon: FileBraces,
      run: () => void router.replace(sessionTextLocation(id())),
    },
    {
      id: 'import',
      text: 'Import…',
      title: 'Import a session file',
      icon: Import,
      isFirst: true,
      run: () => chooseFiles('.session,.json', importFiles),
    },
    {
      id: 'export',
      text: 'Export',
      title: 'Export this session as a file',
      icon: Download,
      run: () => void exportFile(),
    },
    {
      id: 'delete',
      text: 'Delete',
      title: 'Delete this session',
      icon: Trash2,
      danger: true,
      isFirst: true,
      run: () => void remove(),
    },
  ]);

  return {
    list,
    question,
    taken,
    copyName: copy,
    saveAs,
    open: async ({ id }) => void (await router.push(sessionLocation(id))),
  };
}
