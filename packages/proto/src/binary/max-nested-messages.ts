/**
 * Messages that one message may hold, at all depths together. An empty client takes 2 bytes on the
 * wire and 240 in memory, so without a limit a request of 10 MB could take more than a gigabyte.
 * The largest honest message we know is the point cloud of a depth camera: 640 by 480 vectors.
 */
export const MAX_NESTED_MESSAGES = 400_000;
