import type { TopicRecord } from '@ubii/proto';
import { type CameraCalibration, DEFAULT_BOARD, parseCalibration } from '@ubii/vision/markers';
import { computed, reactive, shallowRef, watch } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useCalibrations } from '../../devices/camera/calibration-memory.ts';
import type { PictureSettings } from '../../devices/camera/encode-picture.ts';
import type { PictureHabits } from '../../devices/camera/picture-habits.ts';
import { usePictures } from '../../devices/camera/usePictures.ts';
import { useDevice } from '../../devices/useDevice.ts';
import type { PictureSources } from '../../examples/pictures/usePictureSource.ts';
import { useOwnedSession } from '../../sessions/own/useOwnedSession.ts';
import {
  CALIBRATION_COMPONENTS,
  CALIBRATION_DEVICE,
  calibrationSession,
} from './calibration-session.ts';

/** Sharp corners are required; the module processes ten pictures a second. */
const SETTINGS: PictureSettings = { width: 640, rateHz: 10, encoding: 'JPEG', quality: 0.9 };
/** Fixed size: a scaled picture has different camera parameters. */
const HABITS: PictureHabits = { isAdaptive: false, keepsNewest: false };
const MARKER_PART = DEFAULT_BOARD.markerMetres / DEFAULT_BOARD.squareMetres;

/** Calibrates the camera of this page with a session of its own, in a worker of this tab. */
export function useCalibration(sources: PictureSources) {
  const { isConnected, name } = useConnection();
  const calibrations = useCalibrations();
  const camera = computed(() => sources.camera.chosen.value);
  const board = reactive({
    columns: String(DEFAULT_BOARD.columns),
    rows: String(DEFAULT_BOARD.rows),
    squareMm: String(DEFAULT_BOARD.squareMetres * 1000),
  });
  const views = shallowRef(0);
  const hint = shallowRef('');
  const error = shallowRef('');
  const corners = shallowRef<TopicRecord>();
  const result = shallowRef<{ readonly json: string; readonly calibration: CameraCalibration }>();
  const isSaved = shallowRef(false);

  const device = useDevice({
    name: CALIBRATION_DEVICE,
    tags: ['camera', 'web interface'],
    components: CALIBRATION_COMPONENTS,
    receivers: {
      calibration(json) {
        result.value = { json, calibration: parseCalibration(json) };
        isSaved.value = false;
      },
      views: (count) => (views.value = count),
      hint: (text) => (hint.value = text),
      error: (text) => (error.value = text),
      corners: (_value, record) => (corners.value = record),
    },
  });
  const isOn = computed(() => sources.camera.stream.value !== undefined);
  usePictures({
    source: () => sources.source(),
    isWanted: () =>
      isOn.value &&
      result.value === undefined &&
      isConnected.value &&
      device.isRegistered.value &&
      sources.element.value !== undefined,
    settings: SETTINGS,
    habits: () => HABITS,
    publish: (picture, { ageMs, expiryMs }) =>
      device.publishTaken('image', picture, ageMs, { immediate: true, expiryMs }),
    end: () => device.end('image'),
  });
  const session = useOwnedSession({
    life: 'page',
    spec: () => {
      const squareMetres = Number(board.squareMm) / 1000;
      if (!isOn.value || !device.isRegistered.value || !(squareMetres > 0)) return undefined;
      const printed = {
        columns: Number(board.columns),
        rows: Number(board.rows),
        squareMetres,
        markerMetres: squareMetres * MARKER_PART,
      };
      return {
        place: 'tab',
        session: calibrationSession(name.value, printed, (one) => device.topicOf(one)!),
      };
    },
  });

  function startOver(): void {
    result.value = undefined;
    views.value = 0;
    hint.value = '';
    device.publish('start_over', true);
  }
  // Views of different cameras must not be mixed.
  watch(camera, (_now, before) => before !== '' && startOver());
  watch(isOn, (on) => on || (corners.value = undefined));

  return {
    board,
    views,
    hint,
    error,
    corners,
    result,
    isOn,
    /** Topic of the pictures while they are sent. */
    sentTopic: computed(() =>
      isOn.value && device.isRegistered.value ? device.topicOf('image') : undefined,
    ),
    isSaved,
    /** Stored calibration of the current camera. */
    saved: computed(() => {
      const json = calibrations.of(camera.value);
      return json === undefined ? undefined : parseCalibration(json);
    }),
    save(): void {
      if (result.value === undefined) return;
      calibrations.keep(camera.value, result.value.json);
      isSaved.value = true;
    },
    startOver,
    ...session,
  };
}
