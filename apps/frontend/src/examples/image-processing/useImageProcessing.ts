import { parseDataFormat, type TopicRecord } from '@ubii/proto';
import { useIntervalFn } from '@vueuse/core';
import { computed, reactive, shallowRef, watch } from 'vue';
import { useTopic, VISIBLE_HZ } from '../../connection/live/useTopic.ts';
import { useConnection } from '../../connection/useConnection.ts';
import type { PictureSettings } from '../../devices/camera/encode-picture.ts';
import { RateMeter } from '../../devices/sensors/rate-meter.ts';
import { useDevice } from '../../devices/useDevice.ts';
import { useModuleLibrary } from '../../modules/library/useModuleLibrary.ts';
import { useOwnedSession } from '../../sessions/own/useOwnedSession.ts';
import type { PictureSources } from '../pictures/usePictureSource.ts';
import { useIsOn } from '../pictures/useIsOn.ts';
import { useKeptChoice, useKeptPlace } from '../pictures/useKeptChoice.ts';
import { useLookedAt } from '../pictures/useLookedAt.ts';
import { useSentPictures } from '../pictures/useSentPictures.ts';
import {
  outputTopic,
  parametersOf,
  PROCESSING_DEVICE,
  processingSession,
  takesPictures,
} from './processing-session.ts';

const FIRST_MODULE = 'image-tools';
/** Greyscale, so that the effect of the module is visible; its own defaults change nothing. */
const FIRST_PARAMETERS: ReadonlyMap<string, string> = new Map([['format', '{"string":"GRAY8"}']]);
const SETTINGS: PictureSettings = { width: 480, rateHz: 15, encoding: 'RGB8', quality: 0.8 };

/** Time without a result of a slow module, milliseconds. */
const SLOW_MS = 5000;
const FIGURES_MS = 1000;

/** An output and its newest value. */
export interface ShownOutput {
  readonly name: string;
  readonly format: string;
  readonly topic: string;
  readonly record: TopicRecord | undefined;
}

/** Sends the pictures of a source through one module, in a session of this page. */
export function useImageProcessing(sources: PictureSources) {
  const { client, name } = useConnection();
  const library = useModuleLibrary();
  const { isOn, wasEnded } = useIsOn(sources);
  const place = useKeptPlace();
  const moduleName = useKeptChoice('module', FIRST_MODULE);
  /** Set parameters, by module and parameter name. */
  const set = shallowRef<ReadonlyMap<string, ReadonlyMap<string, string>>>(
    new Map([[FIRST_MODULE, FIRST_PARAMETERS]]),
  );
  const settings = reactive<PictureSettings>({ ...SETTINGS });

  const modules = computed(() =>
    (library.entries.value ?? []).map(({ module }) => module).filter(takesPictures),
  );
  // The chosen module may have been removed.
  watch(modules, (all) => {
    if (all.length > 0 && module.value === undefined) moduleName.value = FIRST_MODULE;
  });
  const module = computed(() => modules.value.find((one) => one.name === moduleName.value));
  const parameters = computed(() => set.value.get(moduleName.value) ?? new Map<string, string>());

  const device = useDevice({
    name: PROCESSING_DEVICE,
    tags: ['example', 'camera'],
    components: [
      {
        name: 'source',
        format: 'image2D',
        tags: ['camera', 'image'],
        description: 'The newest picture of the source.',
      },
    ],
  });
  const { isOwn, image, habits, measures, held } = useSentPictures({
    sources,
    isOn,
    settings,
    isRegistered: device.isRegistered,
    ownTopic: () => device.topicOf('source'),
    publish: (picture, { takenMs: timestampMs, expiryMs }) =>
      device.publish('source', picture, { timestampMs, immediate: true, expiryMs }),
    end: () => device.end('source'),
  });

  const session = useOwnedSession({
    life: 'page',
    spec: () => {
      const chosen = module.value;
      if (!isOn.value || image.value === undefined || chosen === undefined) return undefined;
      return {
        place: place.value,
        session: processingSession({
          owner: name.value,
          clientId: client.id,
          module: chosen,
          image: image.value,
          parameters: parameters.value,
        }),
      };
    },
    onFailure: () => (isOn.value = false),
  });

  const topics = computed(() =>
    isOn.value && session.session.value && module.value
      ? module.value.outputs.map(({ internalName }) => outputTopic(client.id, internalName))
      : [],
  );
  const { byTopic: newest } = useTopic(topics, { maxRateHz: VISIBLE_HZ });
  // Modules have outputs of the same name: drop the values of the previous module.
  let chosenMs = -Infinity;
  const ofOthers = shallowRef<ReadonlySet<TopicRecord>>(new Set());
  watch([moduleName, isOn], () => {
    chosenMs = client.masterTime.nowMs();
    ofOthers.value = new Set(newest.value.values());
  });
  function isOld(record: TopicRecord): boolean {
    return ofOthers.value.has(record) || (record.timestampMs ?? Infinity) < chosenMs;
  }
  const outputs = computed((): ShownOutput[] =>
    (module.value?.outputs ?? []).map(({ internalName, messageFormat }) => {
      const topic = outputTopic(client.id, internalName);
      const record = newest.value.get(topic);
      const format = parseDataFormat(messageFormat) ?? messageFormat;
      return {
        name: internalName,
        format,
        topic,
        record: record?.format === format && !isOld(record) ? record : undefined,
      };
    }),
  );

  const lookedAt = useLookedAt(
    sources,
    () =>
      outputs.value.flatMap(({ record }) =>
        record?.format === 'image2D' || record?.format === 'object2DList' ? record : [],
      ),
    held,
  );

  // A module can output several results per picture, and some outputs only after changes: use the highest rate.
  const meters = new Map<string, RateMeter>();
  const resultHz = shallowRef<number>();
  watch(newest, (records, before) => {
    for (const [topic, record] of records) {
      if (before.get(topic) === record) continue;
      let meter = meters.get(topic);
      if (!meter) meters.set(topic, (meter = new RateMeter(SLOW_MS)));
      meter.note(performance.now());
    }
  });
  watch([isOn, moduleName, place], () => {
    meters.clear();
    resultHz.value = undefined;
  });
  useIntervalFn(() => {
    const nowMs = performance.now();
    const rates = [...meters.values()].flatMap((meter) => meter.rateHz(nowMs) ?? []);
    resultHz.value = rates.length > 0 ? Math.max(...rates) : undefined;
  }, FIGURES_MS);

  return {
    isOn,
    wasEnded,
    place,
    moduleName,
    modules,
    module,
    parameters,
    parameterList: computed(() => (module.value ? parametersOf(module.value) : [])),
    /** @param json undefined: the default of the module */
    setParameter(parameter: string, json: string | undefined): void {
      const next = new Map(parameters.value);
      if (json === undefined) next.delete(parameter);
      else next.set(parameter, json);
      set.value = new Map(set.value).set(moduleName.value, next);
    },
    image,
    isOwn,
    habits,
    settings,
    measures,
    outputs,
    lookedAt,
    resultHz,
    ...session,
  };
}
