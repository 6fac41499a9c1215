/** Builds the library as one script without imports, whose value, when it is evaluated, is the library. */
export function buildLibrary(outfile: string): Promise<void>;
