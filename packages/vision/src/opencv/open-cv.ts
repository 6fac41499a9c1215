/** An object in the memory of OpenCV, which is there until it is deleted. */
export interface CvObject {
  delete(): void;
}

/** A matrix. Its arrays are views of the memory: read or written at once, not kept. */
export interface CvMat extends CvObject {
  readonly rows: number;
  readonly cols: number;
  readonly data: Uint8Array;
  readonly data32S: Int32Array;
  readonly data32F: Float32Array;
  readonly data64F: Float64Array;
  clone(): CvMat;
}

export interface CvMatVector extends CvObject {
  size(): number;
  /** A new matrix, which has to be deleted too. */
  get(index: number): CvMat;
  push_back(mat: CvMat): void;
}

export interface CvSize {
  readonly width: number;
  readonly height: number;
}

export interface CvDictionary extends CvObject {
  /** Draws a marker with a border of black cells, `sidePixels` wide. */
  generateImageMarker(id: number, sidePixels: number, image: CvMat, borderBits: number): void;
}

export interface CvDetectorParameters extends CvObject {
  cornerRefinementMethod: number;
}

export interface CvArucoDetector extends CvObject {
  /** `corners`: 1 × 4 points (float) for each marker; `ids`: its number. */
  detectMarkers(image: CvMat, corners: CvMatVector, ids: CvMat, rejected: CvMatVector): void;
}

export interface CvCharucoDetector extends CvObject {
  /** `corners`: points (float) between the squares; `ids`: which ones. Markers are looked for when none are given. */
  detectBoard(
    image: CvMat,
    corners: CvMat,
    ids: CvMat,
    markerCorners: CvMatVector,
    markerIds: CvMat,
  ): void;
}

/** The part of OpenCV.js that is used here. */
export interface OpenCv {
  readonly CV_8UC1: number;
  readonly CV_32FC2: number;
  readonly CV_32FC3: number;
  readonly CV_64FC1: number;
  readonly SOLVEPNP_IPPE_SQUARE: number;
  readonly Mat: {
    new (): CvMat;
    new (rows: number, cols: number, type: number): CvMat;
  };
  readonly MatVector: new () => CvMatVector;
  readonly Size: new (width: number, height: number) => CvSize;
  readonly aruco_DetectorParameters: new () => CvDetectorParameters;
  readonly aruco_RefineParameters: new (
    minRepDistance: number,
    errorCorrectionRate: number,
    checkAllOrders: boolean,
  ) => CvObject;
  readonly aruco_CharucoParameters: new () => CvObject;
  readonly aruco_ArucoDetector: new (
    dictionary: CvDictionary,
    parameters: CvDetectorParameters,
    refine: CvObject,
  ) => CvArucoDetector;
  readonly aruco_CharucoBoard: new (
    squares: CvSize,
    squareSize: number,
    markerSize: number,
    dictionary: CvDictionary,
    ids: CvMat,
  ) => CvObject;
  readonly aruco_CharucoDetector: new (
    board: CvObject,
    charuco: CvObject,
    parameters: CvDetectorParameters,
    refine: CvObject,
  ) => CvCharucoDetector;
  getPredefinedDictionary(number: number): CvDictionary;
  solvePnP(
    objectPoints: CvMat,
    imagePoints: CvMat,
    cameraMatrix: CvMat,
    distortion: CvMat,
    rotation: CvMat,
    translation: CvMat,
    useGuess: boolean,
    method: number,
  ): boolean;
  solvePnPRefineLM(
    objectPoints: CvMat,
    imagePoints: CvMat,
    cameraMatrix: CvMat,
    distortion: CvMat,
    rotation: CvMat,
    translation: CvMat,
  ): void;
  projectPoints(
    objectPoints: CvMat,
    rotation: CvMat,
    translation: CvMat,
    cameraMatrix: CvMat,
    distortion: CvMat,
    imagePoints: CvMat,
  ): void;
  calibrateCameraExtended(
    objectPoints: CvMatVector,
    imagePoints: CvMatVector,
    size: CvSize,
    cameraMatrix: CvMat,
    distortion: CvMat,
    rotations: CvMatVector,
    translations: CvMatVector,
    deviationsIntrinsics: CvMat,
    deviationsExtrinsics: CvMat,
    perViewErrors: CvMat,
    flags: number,
  ): number;
  /** Converts a thrown number to an error. */
  exceptionFromPtr(pointer: number): { readonly msg: string };
}

/** Options of the script in the asset set `opencv`. */
export interface OpenCvOptions {
  /** Hands over the instance when it is there. */
  readonly instantiateWasm: (
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance) => void,
  ) => object;
  readonly onRuntimeInitialized: () => void;
  readonly onAbort: (reason: unknown) => void;
  readonly print: (line: string) => void;
  readonly printErr: (line: string) => void;
}

/** The value of the script in the asset set `opencv`. It is ready when `onRuntimeInitialized` is called. */
export type OpenCvFactory = (options: OpenCvOptions) => OpenCv & { then?: unknown };
