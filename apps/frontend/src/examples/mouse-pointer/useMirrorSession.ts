import { ConnectionError } from '@ubii/client-web';
import {
  moduleEventTopic,
  ServiceError,
  sessionStatisticsTopic,
  type ModuleStatistics,
  type Session,
} from '@ubii/proto';
import { computed, onScopeDispose, shallowRef, watch, type ComputedRef, type Ref } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { eventPlace } from '../../sessions/live/event-log.ts';
import { removeOnPageHide } from '../../sessions/own/remove-on-page-hide.ts';
import { useTabNode } from '../../tab-node/useTabNode.ts';
import { isMirrorSessionOf, mirrorSession, onNode } from './mirror-session.ts';

/** The node that mirrors the pointer. */
export type MirrorPlace =
  | { readonly kind: 'master' }
  | { readonly kind: 'tab' }
  | { readonly kind: 'node'; readonly nodeId: string };

export interface MirrorSession {
  /** The session on the master; `undefined` while there is none. */
  readonly session: ComputedRef<Session | undefined>;
  readonly statistics: ComputedRef<ModuleStatistics | undefined>;
  /** The last error of the module or of a service request, one sentence. */
  readonly trouble: Ref<string | undefined>;
  /** True when the last service request failed, so that the session does not run on the chosen node. */
  readonly hasFailed: Ref<boolean>;
  /** Creates the session again. */
  restart(): Promise<void>;
}

const NODES_INTERVAL_MS = 2000;

/**
 * Keeps a session of this page running at `place` while the calling scope lives. The client sends the
 * whole session: source, mappings and node.
 */
export function useMirrorSession(place: Readonly<Ref<MirrorPlace>>): MirrorSession {
  const { client, name, isConnected, sessions, nodes } = useConnection();
  const tab = useTabNode();
  nodes.watch(NODES_INTERVAL_MS);
  const id = shallowRef<string>();
  const trouble = shallowRef<string>();
  const hasFailed = shallowRef(false);
  let releaseTab: (() => void) | undefined;
  let isOver = false;

  const session = computed(() => sessions.list.value?.find((one) => one.id === id.value));

  /** Returns the node for the module. Starts the node of this tab if needed. */
  async function nodeId(): Promise<string> {
    const wanted = place.value;
    if (wanted.kind !== 'tab') {
      releaseTab?.();
      releaseTab = undefined;
      return wanted.kind === 'node' && wanted.nodeId !== '' ? wanted.nodeId : 'master';
    }
    releaseTab ??= tab.need();
    await tab.whenOn();
    return client.id;
  }

  async function send(): Promise<void> {
    const [{ mirrorPointer }, { moduleToWire }] = await Promise.all([
      import('@ubii/modules'),
      import('@ubii/pm-sandbox'),
    ]);
    const { elements } = await client.call('sessionRuntimeGetList');
    // A session from before a reload would mirror the pointer a second time
    for (const left of elements.filter((one) => isMirrorSessionOf(one, client.id))) {
      await client.call('sessionRuntimeRemove', { id: left.id });
    }
    const spec = mirrorSession({
      clientId: client.id,
      clientName: name.value,
      module: moduleToWire(mirrorPointer),
      nodeId: await nodeId(),
    });
    if (isOver) return;
    take(await client.call('sessionRuntimeStart', spec));
  }

  async function move(): Promise<void> {
    if (id.value === undefined) return send();
    const known = await client.call('sessionRuntimeGet', { id: id.value });
    take(await client.call('sessionRuntimeUpdate', onNode(known, await nodeId())));
  }

  function take(answer: Session): void {
    sessions.take(answer);
    id.value = answer.id;
    if (isOver) end();
  }

  /** Serialises changes, however fast the place is switched. */
  let changes: Promise<void> = Promise.resolve();
  function inTurn(intent: () => Promise<void>): Promise<void> {
    changes = changes.then(async () => {
      if (isOver || !isConnected.value) return;
      trouble.value = undefined;
      hasFailed.value = false;
      try {
        await intent();
      } catch (cause) {
        if (cause instanceof ServiceError && cause.code === 'not_found') id.value = undefined;
        if (cause instanceof ConnectionError) return; // Shown by the shell; retried after reconnecting.
        trouble.value = cause instanceof Error ? cause.message : String(cause);
        hasFailed.value = true;
      }
    });
    return changes;
  }

  watch(place, (next) => {
    // Without another node, the module stays where it is.
    if (next.kind !== 'node' || next.nodeId !== '') void inTurn(move);
  });
  watch(isConnected, (connected) => connected && void inTurn(send), { immediate: true });

  const { newest: report } = useTopic(() => id.value && sessionStatisticsTopic(id.value), {
    format: 'sessionStatistics',
  });
  useTopic(() => id.value && moduleEventTopic(id.value), {
    format: 'moduleEvent',
    keep: 0,
    onRecord({ value }) {
      const at = eventPlace(value);
      trouble.value = at === '' ? value.message : `${value.message} (${at})`;
    },
  });

  function end(): void {
    const gone = id.value;
    id.value = undefined;
    if (gone === undefined) return;
    sessions.drop(gone);
    client.call('sessionRuntimeRemove', { id: gone }).catch(() => undefined); // already removed
  }
  onScopeDispose(() => {
    isOver = true;
    end();
    releaseTab?.();
  });
  removeOnPageHide(client, () => id.value);

  return {
    session,
    statistics: computed(() => report.value?.value.modules[0]),
    trouble,
    hasFailed,
    restart: () =>
      inTurn(async () => {
        end();
        await send();
      }),
  };
}
