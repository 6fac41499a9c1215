import { ConnectionError } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { ref, watch, type Ref } from 'vue';
import { useRouter } from 'vue-router';
import { useConnection } from '../../connection/useConnection.ts';
import type { SessionCalls } from '../../sessions/actions/session-calls.ts';
import { sessionSpec } from '../../sessions/text/session-spec.ts';
import { moveDraft } from '../model/changes/draft.ts';
import { graphLocation } from '../routes.ts';
import type { GraphEditor } from './graph-editor.ts';
import type { Drafts, GoOn } from './use-draft.ts';
import type { Saving } from './use-save.ts';

/** What is done when the master does not have the session any more. */
export interface SessionGone {
  /** It was looked for, and is not on the disk either. */
  readonly isLost: Ref<boolean>;
  /** Makes it anew of what is here. */
  putBack(): Promise<void>;
}

interface GoneParts {
  readonly editor: GraphEditor;
  readonly saving: Saving;
  readonly drafts: Drafts;
  readonly calls: SessionCalls;
}

/**
 * A master that was started anew has its stored sessions under other ids: the editor goes on with the
 * one of the same name. What it does not have at all stays on the screen.
 */
export function useSessionGone(
  isGone: () => boolean,
  { editor, saving, drafts, calls }: GoneParts,
): SessionGone {
  const { client, isConnected } = useConnection();
  const router = useRouter();
  const isLost = ref(false);
  /** The link was lost: it may be another run of the master. Else somebody has deleted it. */
  let mayBeAnew = false;
  watch(isConnected, (connected) => {
    if (!connected) mayBeAnew = true;
  });

  async function goTo(id: string): Promise<void> {
    drafts.keep();
    moveDraft(localStorage, editor.session.value.id, id);
    drafts.pause();
    const state: GoOn = { goOn: true, save: saving.isWaiting.value };
    await router.replace({ ...(graphLocation(id) as object), state: { ...state } });
  }

  async function look(): Promise<void> {
    try {
      const { name, extension } = editor.session.value;
      const { elements } = await client.call('sessionDatabaseGetList');
      const stored = elements.find((one) => one.name === name);
      if (!isGone()) return;
      if (!mayBeAnew || stored === undefined || extension?.stored !== true) isLost.value = true;
      else await goTo((await calls.open(stored)).id);
    } catch (cause) {
      if (!(cause instanceof ConnectionError || cause instanceof ServiceError)) throw cause;
      isLost.value = true;
    }
  }
  watch(
    isGone,
    (gone) => {
      isLost.value = false;
      if (gone) void look();
      else mayBeAnew = false;
    },
    { immediate: true },
  );

  return {
    isLost,
    async putBack() {
      const made = await calls.create(sessionSpec(editor.toSession()));
      drafts.forget(editor.session.value.id);
      await router.replace(graphLocation(made.id));
    },
  };
}
