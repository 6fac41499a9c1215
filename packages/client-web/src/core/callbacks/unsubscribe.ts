/** Takes a callback back; calling it again does nothing. */
export type Unsubscribe = () => void;
