import { useClipboard } from '@vueuse/core';
import { shallowRef, type ShallowRef } from 'vue';
import { useRouter } from 'vue-router';
import { useToasts } from '../ui/toasts/toasts.ts';
import type { ClientIntent } from './act/client-menu.ts';
import { useClientActions } from './act/useClientActions.ts';
import type { ClientView } from './model/client-view.ts';

/** Actions on clients, from the menu to the request, with dialogs in between. */
export interface ClientIntents {
  /** Reason why the last action failed; kept until the next one. */
  readonly failure: ShallowRef<string | undefined>;
  /** Open dialog, and its client. */
  readonly question: Readonly<
    ShallowRef<{ readonly about: 'throttle' | 'disconnect'; readonly view: ClientView } | undefined>
  >;
  /** Id of the client being renamed. */
  readonly renaming: ShallowRef<string | undefined>;
  run(intent: ClientIntent, view: ClientView): void;
  dismiss(): void;
  rename(view: ClientView, name: string): Promise<void>;
  throttle(rate: number, reason: string): Promise<void>;
  disconnect(reason: string): Promise<void>;
}

/** @param show selects a client */
export function useClientIntents(show: (view: ClientView) => void): ClientIntents {
  const actions = useClientActions();
  const router = useRouter();
  const toasts = useToasts();
  // Without a secure context there is no clipboard API; `legacy` uses `execCommand`.
  const { copy } = useClipboard({ legacy: true });
  const question: ClientIntents['question'] & ShallowRef = shallowRef();
  const renaming = shallowRef<string>();

  async function copyId(id: string): Promise<void> {
    await copy(id);
    toasts.show('Copied the client id');
  }

  function ask(about: 'throttle' | 'disconnect', view: ClientView): void {
    actions.failure.value = undefined;
    question.value = { about, view };
  }

  function run(intent: ClientIntent, view: ClientView): void {
    switch (intent) {
      case 'identify':
        return void actions.identify(view);
      case 'rename':
        show(view);
        renaming.value = view.client.id;
        return;
      case 'topics':
        return void router.push({ path: '/topics', query: { client: view.client.id } });
      case 'copy-id':
        return void copyId(view.client.id);
      case 'throttle':
      case 'disconnect':
        return ask(intent, view);
      case 'unthrottle':
        return void actions.throttle(view, 0, '');
    }
  }

  return {
    failure: actions.failure,
    question,
    renaming,
    run,
    dismiss: () => (question.value = undefined),
    async rename(view, name) {
      if (await actions.rename(view, name)) renaming.value = undefined;
    },
    async throttle(rate, reason) {
      if (question.value && (await actions.throttle(question.value.view, rate, reason))) {
        question.value = undefined;
      }
    },
    async disconnect(reason) {
      if (question.value && (await actions.disconnect(question.value.view, reason))) {
        question.value = undefined;
      }
    },
  };
}
