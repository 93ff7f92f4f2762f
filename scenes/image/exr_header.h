// Validates the header of an EXR file before the OpenEXR library opens it, because the library allocates
// whatever sizes the header claims. Layout: OpenEXR documentation, "OpenEXR File Layout" (magic number,
// version field, attributes).
#pragma once

namespace plumbline {

class InputFile;

/// Reads from the beginning of the file. Throws InputError if it is not an EXR, deep, cropped, larger than 1
/// Gpixel, an environment map or a stereo image, if its parts differ in size, if its header exceeds 16 MB, or
/// if it is too short to contain the pixels it claims.
void checkExrHeader(InputFile& file);

} // namespace plumbline
