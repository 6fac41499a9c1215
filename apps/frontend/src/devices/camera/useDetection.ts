import { ConnectionError } from '@ubii/client-web';
import { SERVICES, toJson, type Init, type Session } from '@ubii/proto';
import { useEventListener } from '@vueuse/core';
import { computed, onScopeDispose, shallowRef, watch, type ComputedRef, type Ref } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useTabNode } from '../../tab-node/useTabNode.ts';

/** Where objects in the pictures are detected. */
export type DetectionPlace = 'off' | 'tab' | 'master';

/** Detection of objects in the pictures of this camera, as a session of this page. */
export interface Detection {
  readonly place: Ref<DetectionPlace>;
  /** `undefined` while there is none. */
  readonly session: ComputedRef<Session | undefined>;
  /** Error of the last change, or what is wrong with the session, one sentence. */
  readonly trouble: ComputedRef<string | undefined>;
}

const MODULE = 'object-detection';

/** The session that existing programs would make of it: pictures in, boxes out. */
function detectionSession(
  owner: string,
  image: string,
  objects: string,
  nodeId: string,
): Init<Session> {
  return {
    name: `Objects in the pictures of ${owner}`,
    description:
      'Detects objects in the pictures of a camera. It ends with the page of the camera.',
    tags: ['camera'],
    processingModules: [{ name: MODULE, nodeId }],
    ioMappings: [
      {
        processingModuleName: MODULE,
        inputMappings: [{ inputName: 'image', topic: image }],
        outputMappings: [{ outputName: 'predictions', topic: objects }],
      },
    ],
  };
}

/** The session with its module on another node. */
function onNode(session: Session, nodeId: string): Session {
  const processingModules = session.processingModules.map((module) => ({
    ...module,
    nodeId,
    extension: module.extension && { ...module.extension, replaceable: false },
  }));
  return { ...session, processingModules };
}

/** @param topicOf the topics of the camera, as soon as the master knows it */
export function useDetection(
  topicOf: (component: 'camera_image' | 'objects') => string | undefined,
): Detection {
  const { client, name, sessions } = useConnection();
  const tab = useTabNode();
  const place = shallowRef<DetectionPlace>('off');
  const id = shallowRef<string>();
  const failure = shallowRef<string>();
  let releaseTab: (() => void) | undefined;
  let isOver = false;
  const session = computed(() => sessions.list.value?.find((one) => one.id === id.value));

  async function nodeId(): Promise<string> {
    if (place.value === 'tab') {
      releaseTab ??= tab.need();
      await tab.whenOn();
      return client.id;
    }
    releaseTab?.();
    releaseTab = undefined;
    return 'master';
  }

  async function apply(): Promise<void> {
    if (place.value === 'off') return end();
    const [image, objects] = [topicOf('camera_image'), topicOf('objects')];
    if (image === undefined || objects === undefined) {
      throw new Error('The master does not know this camera yet. Choose again in a moment.');
    }
    const node = await nodeId();
    if (isOver) return;
    const known = id.value === undefined ? undefined : sessions.find(id.value);
    const answer = known
      ? await client.call('sessionRuntimeUpdate', onNode(known, node))
      : await client.call(
          'sessionRuntimeStart',
          detectionSession(name.value, image, objects, node),
        );
    sessions.take(answer);
    id.value = answer.id;
    if (isOver) end();
  }

  function end(): void {
    const gone = id.value;
    id.value = undefined;
    releaseTab?.();
    releaseTab = undefined;
    if (gone === undefined) return;
    sessions.drop(gone);
    client.call('sessionRuntimeRemove', { id: gone }).catch(() => undefined); // it is gone already
  }

  /** One change after the other, however fast the place is chosen. */
  let changes: Promise<void> = Promise.resolve();
  watch(place, () => {
    changes = changes.then(async () => {
      failure.value = undefined;
      try {
        await apply();
      } catch (cause) {
        if (cause instanceof ConnectionError) return; // shown by the shell
        failure.value = cause instanceof Error ? cause.message : String(cause);
        place.value = 'off';
      }
    });
  });
  onScopeDispose(() => {
    isOver = true;
    end();
  });
  // A page that is closed has no time for an answer.
  useEventListener(window, 'pagehide', () => {
    if (id.value === undefined) return;
    const request = { topic: SERVICES.sessionRuntimeRemove.topic, session: { id: id.value } };
    const body = JSON.stringify(toJson('ubii.services.ServiceRequest', request));
    navigator.sendBeacon('/services/json', new Blob([body], { type: 'application/json' }));
  });

  return {
    place,
    session,
    trouble: computed(
      () =>
        failure.value ?? session.value?.extension?.problems.find(({ isError }) => isError)?.message,
    ),
  };
}
