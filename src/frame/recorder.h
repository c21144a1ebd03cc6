// SPDX-License-Identifier: MIT
// The recorder: every pass of every technique and of the renderer goes through dispatch() or
// draw().
//
// It records at once, in the order of the calls. What it adds to each pass, without a line in the
// pass itself: barriers, a debug label, a timer, capture of images whose name is watched, a scan
// for values that are not light. Names, formats and sizes are checked against the shader's
// reflection; a mismatch is a broken promise of the pass and stops the program with both names.
//
// What can fail at run time (memory, pipelines) is remembered: after the first error all calls do
// nothing, images are invalid, and the frame's finish() tells it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "gpu/command_list.h"
#include "lueur/buffer.h"
#include "lueur/context.h"
#include "shading/gpu.h"

namespace lueur {

// An extent as parameter structures have it.
inline ivec2 as_ivec2(Extent e) {
  return ivec2(e.width, e.height);
}

// A persistent image that only ever is sampled, such as a scene's texture.
struct SampledTexture {
  const gpu::Texture* texture = nullptr;
};

// A resource for the binding of this name in the shader.
struct Bound {
  const char* name;
  std::variant<Image, BufferRef, SampledTexture> resource;
  gpu::SamplerState sampler{};  // of sampler2D and the like
};

// The bytes of a parameter structure, shared between C++ and GLSL (scalar layout). They go to the
// shader's push constants, or to its uniform block `params` if it has one. Points at the structure,
// which has to live until it is recorded: a temporary does in the call's own expression only.
struct Params {
  const void* data = nullptr;
  size_t bytes = 0;
  Params() = default;
  template <class T>
  Params(const T& value) : data(&value), bytes(sizeof(T)) {
    static_assert(std::is_trivially_copyable_v<T>);
  }
};

struct Dispatch {
  const gpu::ShaderCode& shader;
  std::vector<gpu::Specialization> constants{};
  Params params{};
  std::vector<Bound> read{};
  std::vector<Bound> write{};
  Extent over{};  // threads; workgroups are rounded up, so the shader checks its bounds
  // Instead of `over`: how many workgroups in x, y and z, three uint32 that earlier passes wrote.
  BufferRef groups{};
};

struct DrawTarget {
  const char* name;
  Image image;
  std::array<float, 4> clear{};
  uint32_t layer = 0;
  bool keep = false;  // colour only: draw onto what an earlier pass wrote, instead of clearing it
};

// Textures and buffers of one material, bound as descriptor set 1. Lives as long as the recorder.
struct MaterialSet {
  uint32_t index = 0;
};

class DrawList;

struct Draw {
  gpu::GraphicsState state;  // formats are filled in from the targets
  Params params{};
  std::vector<Bound> read{};
  std::vector<DrawTarget> color{};
  std::optional<DrawTarget> depth{};  // cleared to clear[0]
  std::function<void(DrawList&)> record;
};

// The draws of one pass, in the hands of Draw::record.
class DrawList {
 public:
  void material(MaterialSet set);
  void geometry(const gpu::Buffer& vertices, const gpu::Buffer& indices);
  void front_face(bool counter_clockwise);  // default: true
  void cull_back_faces(bool on);            // default: true
  void push(const Params& params);
  void indexed(uint32_t index_count, uint32_t first_index, int32_t vertex_offset,
               uint32_t instance_count, uint32_t first_instance);
  // Without vertex attributes: the shader goes by gl_VertexIndex.
  void vertices(uint32_t vertex_count);
  void fullscreen_triangle() { vertices(3); }

 private:
  friend class Recorder;
  DrawList(Recorder& recorder, const gpu::Pipeline& pipeline)
      : recorder_(recorder), pipeline_(pipeline) {}
  Recorder& recorder_;
  const gpu::Pipeline& pipeline_;
};

struct HistoryImage {
  Image previous;
  Image current;
  bool valid = false;  // previous holds last frame's current
};

// Pixels that came back from the device.
struct Pixels {
  std::string name;  // "pass.image", or what read_back() was given
  Extent extent;
  uint32_t channels = 0;
  std::vector<float> samples;  // interleaved, rows from the top
};

// What a scan found in one image of one pass.
struct ScanFinding {
  std::string image;                             // "pass.image"
  uint32_t nan = 0, infinite = 0, negative = 0;  // pixels
  uint32_t first_x = 0, first_y = 0;             // the first of them, in reading order
};

struct RecorderOptions {
  bool scan = false;
  // Names "pass.image" whose content is to be captured; `*` stands for anything. A pattern without
  // an image name means all images of the pass.
  std::vector<std::string> watch;
  // Whose frame this is. Each name has a history of its own, and the frames of other names in
  // between do not end it: for several views or techniques that take turns.
  std::string history_of;
  // A pooled image or buffer that no frame wanted for this long gives its memory back. Never sooner
  // than the device is done with it.
  uint64_t idle_frames = 16;
};

class Recorder {
 public:
  static Result<std::unique_ptr<Recorder>> create(const ContextInfo& info);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  RecorderOptions options;  // change them between frames

  void begin(VkCommandBuffer command_buffer);
  Result<void> finish();

  // A transient image, from a pool; content undefined. Held until release() or the frame's end.
  Image image(const char* name, Extent extent, Format format);
  Image cube(const char* name, uint32_t side, Format format);
  void release(Image image);
  // An image that outlives the frame, and what it held in the frame before, of those of
  // `options.history_of`. Both sides start invalid when the name is new or its extent or format has
  // changed.
  HistoryImage history(const std::string& name, Extent extent, Format format);
  void forget_history();  // of all
  Image import(const ExternalImage& image);
  // Copies all of `from` to `to`, of the same extent and format.
  void copy(Image from, Image to);

  // A transient image with the CPU's pixels: tightly packed rows of `format`, from the top.
  Image upload_image(const char* name, Extent extent, Format format, const void* pixels);

  // A transient storage buffer in device memory; content undefined.
  BufferRef buffer(const char* name, uint64_t bytes);
  BufferRef import(const ExternalBuffer& buffer);  // readonly in shaders
  // Bytes of the CPU for this frame, as a storage or uniform buffer.
  BufferRef upload(const void* data, uint64_t bytes);
  template <class T>
  BufferRef upload(const std::vector<T>& items) {
    return upload(items.data(), items.size() * sizeof(T));
  }

  void dispatch(const std::string& pass, const Dispatch& info);
  void draw(const std::string& pass, const Draw& info);
  MaterialSet material_set(std::vector<Bound> bindings);

  // Copies an image for the CPU; find it by `name` in read_back_pixels() once the frame completed.
  void read_back(const std::string& name, Image image);

  // Valid after the frame's work has completed on the device.
  std::vector<Pixels> read_back_pixels();
  std::vector<ScanFinding> scan_findings();
  void set_timers(Timers timers) { info_.timers = timers; }
  std::vector<PassTime> pass_times() const;

  // Names "pass.image" that the last frame has written, in order.
  const std::vector<std::string>& written_images() const { return written_images_; }
  MemoryUse memory() const { return device_->memory(); }
  // True where a draw may use logic operations, see ContextInfo::logic_op.
  bool has_logic_op() const { return device_->logic_op; }
  // True where shaders run on the CPU: passes then give each thread more pixels.
  bool runs_on_cpu() const { return device_->properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU; }
  gpu::Device& device() { return *device_; }
  gpu::PipelineLibrary& pipelines() { return *pipelines_; }
  bool failed() const { return error_.has_value(); }
  void fail(Error error) {
    if (!error_) error_ = std::move(error);
  }

 private:
  friend class DrawList;
  struct PooledImage {
    gpu::Texture texture;    // empty for imported images
    ExternalImage external;  // of imported images
    gpu::AccessState state;
    std::string name;
    bool in_use = false;
    bool history = false;
    bool written = false;  // in this frame
    uint64_t last_frame = 0;
    VkImage handle() const { return external.image ? external.image : texture.handle(); }
    VkImageView view() const { return external.image ? external.view : texture.view(); }
  };
  struct FrameBuffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    uint64_t offset = 0;
    uint64_t bytes = 0;
    gpu::AccessState* state = nullptr;  // none: written by the CPU before the submit
    bool imported = false;
  };
  struct PooledBuffer {
    gpu::Buffer buffer;
    gpu::AccessState state;
    bool in_use = false;
    uint64_t last_frame = 0;
  };
  struct ReadBack {
    std::string name;
    Extent extent;
    Format format = Format::rgba16f;
    gpu::Buffer buffer;
  };
  struct Slot;  // what belongs to one of the frames in flight
  struct HistoryPair {
    std::array<uint32_t, 2> images{};
    uint64_t last_frame = 0;  // counted by its History
    uint32_t current = 0;
    bool valid = false;  // in last_frame
  };
  struct History {
    uint64_t frame = 0;
    std::map<std::string, HistoryPair> pairs;
  };

  explicit Recorder(const ContextInfo& info);
  Image pooled(const char* name, Extent extent, Format format, bool cube, bool history);
  Image handle_of(uint32_t index) const;
  void trim_pool();

  // Moves resources to the state that a pass wants, with one barrier for all.
  struct Barriers {
    std::vector<gpu::ImageTransition> images;
    std::vector<gpu::BufferTransition> buffers;
  };
  void use_image(Barriers& barriers, Image image, gpu::Use use, bool discard);
  void use_buffer(Barriers& barriers, BufferRef buffer, gpu::Use use);
  // Fills set 0: checks that names, kinds and formats are the shader's.
  VkDescriptorSet bind_resources(const std::string& pass, const gpu::Pipeline& pipeline,
                                 const std::vector<Bound>& read, const std::vector<Bound>& write,
                                 const Params& params, Barriers& barriers);
  gpu::Descriptor describe(const gpu::ShaderBinding& binding, const Bound& bound) const;
  void begin_pass(const std::string& pass, const Barriers& barriers);
  void end_pass();
  void inspect(const std::string& pass, const char* image_name, Image image);
  void scan(const std::string& name, Image image);

  ContextInfo info_;
  std::unique_ptr<gpu::Device> device_;
  std::unique_ptr<gpu::PipelineLibrary> pipelines_;
  std::unique_ptr<gpu::SamplerLibrary> samplers_;
  std::unique_ptr<gpu::DescriptorArena> material_descriptors_;
  std::vector<std::unique_ptr<Slot>> slots_;
  Slot* slot_ = nullptr;
  uint64_t frame_ = 0;
  std::optional<gpu::CommandList> commands_;
  std::optional<Error> error_;

  std::vector<std::unique_ptr<PooledImage>> images_;
  std::vector<std::unique_ptr<PooledBuffer>> buffers_;
  std::vector<FrameBuffer> frame_buffers_;
  std::vector<std::unique_ptr<gpu::AccessState>> imported_buffers_;
  std::map<std::string, History> histories_;
  History* history_ = nullptr;  // of this frame
  std::vector<std::vector<Bound>> material_sets_;
  std::map<std::pair<const gpu::Pipeline*, uint32_t>, VkDescriptorSet> material_descriptor_sets_;
  std::vector<std::string> written_images_;
};

// The thread-group count and pixels-per-thread rounding that the house uses everywhere.
inline uint32_t divide_up(uint32_t a, uint32_t b) {
  return (a + b - 1) / b;
}

}  // namespace lueur
