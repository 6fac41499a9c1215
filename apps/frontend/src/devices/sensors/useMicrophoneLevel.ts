import { onScopeDispose, shallowRef } from 'vue';

/** Interval between measurements, milliseconds. */
const INTERVAL_MS = 50;
/** Number of samples per measurement. */
const SAMPLES = 1024;

export type MicrophoneState = 'off' | 'insecure' | 'missing' | 'asking' | 'refused' | 'on';

/**
 * Loudness: root mean square of the microphone's samples, 0 to 1. No sound leaves this page.
 *
 * @param handle called with the level, 20 times a second
 */
export function useMicrophoneLevel(handle: (level: number) => void) {
  const state = shallowRef<MicrophoneState>(firstState());
  let stop = (): void => undefined;

  async function start(): Promise<void> {
    if (state.value === 'on' || state.value === 'asking') return;
    state.value = 'asking';
    try {
      const stream = await navigator.mediaDevices.getUserMedia({ audio: true });
      // Unmounted in the meantime.
      if (state.value !== 'asking') return endTracks(stream);
      listen(stream);
      state.value = 'on';
    } catch (error) {
      state.value = (error as DOMException).name === 'NotFoundError' ? 'missing' : 'refused';
    }
  }

  function listen(stream: MediaStream): void {
    const context = new AudioContext();
    const analyser = new AnalyserNode(context, { fftSize: SAMPLES });
    context.createMediaStreamSource(stream).connect(analyser);
    const samples = new Float32Array(SAMPLES);
    const timer = setInterval(() => {
      analyser.getFloatTimeDomainData(samples);
      handle(rootMeanSquare(samples));
    }, INTERVAL_MS);
    stop = () => {
      clearInterval(timer);
      endTracks(stream);
      void context.close();
    };
  }

  function end(): void {
    stop();
    stop = () => undefined;
    state.value = firstState();
  }
  onScopeDispose(end);
  return { state, start, stop: end };
}

function firstState(): MicrophoneState {
  if (!isSecureContext) return 'insecure';
  return 'mediaDevices' in navigator ? 'off' : 'missing';
}

function endTracks(stream: MediaStream): void {
  for (const track of stream.getTracks()) track.stop();
}

/** Root mean square: 0 for silence, 1 for a square wave of full amplitude. */
export function rootMeanSquare(samples: Float32Array): number {
  let sum = 0;
  for (const sample of samples) sum += sample * sample;
  return samples.length === 0 ? 0 : Math.sqrt(sum / samples.length);
}
