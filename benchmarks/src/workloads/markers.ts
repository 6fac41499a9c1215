import { MarkerTracker, type Picture } from '@ubii/vision';
import { createOpenCvRuntime, MARKER_IMAGE_SIZE, markerImage } from '@ubii/vision/testing/markers';
import type { Callee } from '../calls/call-series.ts';
import { measureCalls, warmUp } from '../calls/measure-calls.ts';
import type { Subject, Workload } from '../measuring/workload.ts';

const REFERENCE = 'OpenCV.js';

/** Corners are refined to parts of a pixel by both (CORNER_REFINE_SUBPIX). */
const REFINE_SUBPIXEL = 1;

/** Two markers in a grey picture: detection by OpenCV alone, beside that with poses, outlines and clean memory. */
export const markers: Workload = {
  name: 'markers',
  group: 'markers',
  title: 'Two markers in a picture of 640 x 480 pixels',
  figures: [
    {
      key: 'p50Us',
      label: 'p50',
      unit: 'µs',
      isHigherBetter: false,
      goals: { '@ubii/vision': 1.25 },
    },
    { key: 'p99Us', label: 'p99', unit: 'µs', isHigherBetter: false, goals: {} },
  ],
  reference: REFERENCE,
  placement: 'one-core',
  roundShare: 1 / 3,
  open: async () => {
    const picture = markerImage();
    return [
      await subject(REFERENCE, await openCvAlone(picture)),
      await subject('@ubii/vision', wholeTracking(picture)),
    ];
  },
};

/** Detects in a matrix that was filled before, into results that are kept. */
async function openCvAlone(picture: Picture): Promise<Callee<undefined, number>> {
  const runtime = createOpenCvRuntime();
  return runtime.run((cv) => {
    const image = new cv.Mat(picture.height, picture.width, cv.CV_8UC1);
    image.data.set(picture.data);
    const parameters = new cv.aruco_DetectorParameters();
    parameters.cornerRefinementMethod = REFINE_SUBPIXEL;
    const detector = new cv.aruco_ArucoDetector(
      cv.getPredefinedDictionary(0),
      parameters,
      new cv.aruco_RefineParameters(10, 3, true),
    );
    const [corners, ids, rejected] = [new cv.MatVector(), new cv.Mat(), new cv.MatVector()];
    return {
      sequence: 0,
      prepare: () => undefined,
      call: async () => {
        detector.detectMarkers(image, corners, ids, rejected);
        return ids.rows;
      },
      isRight: (count: number) => count === 2,
    };
  });
}

function wholeTracking(picture: Picture): Callee<undefined, readonly { id: number }[]> {
  const tracker = new MarkerTracker(createOpenCvRuntime());
  return {
    sequence: 0,
    prepare: () => undefined,
    call: () => tracker.track(picture, { sizeMetres: MARKER_IMAGE_SIZE }),
    isRight: (found) => found.map(({ id }) => id).join() === '7,23',
  };
}

async function subject<P, A>(name: string, callee: Callee<P, A>): Promise<Subject> {
  await warmUp(callee);
  return { name, pids: [], measure: (options) => measureCalls(callee, options) };
}
