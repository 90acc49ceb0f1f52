// Sizes of layers of array textures, which nothing here makes.

export const getByteLength = undefined;
export const TextureUtils = { getByteLength };
