import { RecorderEngine, type RecorderContext } from './recorder-engine.ts';
import { SharedRecorder, type MemoryLimits } from './shared-recorder.ts';

/** A recorder whose files are written by this thread. */
export function recordHere(
  context: RecorderContext & { readonly limits: MemoryLimits },
): SharedRecorder {
  const { clock, limits } = context;
  return new SharedRecorder({ clock, limits, files: new RecorderEngine(context) });
}
